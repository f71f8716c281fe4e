// The model study: the least model of each scene, the worth of each feature in error and cost, and whether the engine's
// own choice (impulse:auto) is as accurate as the full model.
import * as Plot from "@observablehq/plot";
import { figure } from "../charts/figure";
import { decades, name_axis, plot_look, tip_look } from "../charts/look";
import type { Study } from "../data";
import type { StudyView } from "../model";
import { h, slug, table } from "../dom";
import { folded } from "../folded";
import { count, given, number } from "../format";
import { command, run_command } from "../pieces";
import { least_models, type Drop, type LeastModels, type ModelCase, type Spread } from "./least_model";

const row_height = 20;
const least_change = 1e-9; // m; smaller changes are drawn there

const label = ({ setting }: Drop): string => setting.replaceAll(/(integrator|solver)=/g, "").replaceAll(",", ", ");
const tolerable = 0.01; // m; what adds less is coarse, not useless
const colour = ({ within, change, different, breaks }: Drop): string =>
  within ? "var(--right)" : !different && !breaks && change !== null && change <= tolerable ? "var(--coarse)" : "var(--wrong)";
const change_of = ({ change }: Drop): number => Math.max(least_change, change ?? Infinity);

const described = (drop: Drop): string =>
  [
    `${drop.feature}: without ${drop.without}`,
    drop.setting,
    drop.change === null ? drop.why || "does not run to the end" : drop.different || `adds an error of ${number(drop.change, "m", 2)}`,
    drop.breaks ? `breaks ${drop.breaks}` : "",
    drop.ratio === null ? "" : `${number(drop.ratio, "", 2)} of the cost`,
  ]
    .filter(Boolean)
    .join("\n");

function panel(drops: Drop[], width: number, about: string, x: object, marks: Plot.Markish[]): Element {
  const { marginLeft, axis } = name_axis(width, drops.map(label));
  return Plot.plot({
    ...plot_look(width, 60 + row_height * drops.length),
    marginLeft,
    ariaLabel: about,
    x: { grid: true, labelAnchor: "right", ...x },
    y: { domain: drops.map(label) },
    marks: [axis, ...marks],
  });
}

function cost_panel(drops: Drop[], width: number): Element {
  const timed = drops.filter(({ ratio }) => ratio !== null);
  const most = Math.min(2, Math.max(1.1, ...timed.map(({ ratio }) => ratio ?? 0)));
  const end = ({ ratio }: Drop) => Math.min(ratio ?? 0, most);
  return panel(drops, width, "Cost without each feature, the full model = 1", { label: "cost, full model = 1", domain: [0, most] }, [
    Plot.barX(timed, { x1: 0, x2: end, y: label, fill: colour, fillOpacity: 0.75, insetTop: 3, insetBottom: 3, className: "cost" }),
    Plot.ruleX([1], { stroke: "var(--ink)", strokeDasharray: "2 3" }),
    Plot.tip(timed, Plot.pointerY({ x: end, y: label, title: described, ...tip_look })),
  ]);
}

/** In a chaotic case, how far single motions are from the full model's, which no tolerance limits. */
function error_panel(drops: Drop[], width: number, tolerance: number, chaotic: boolean): Element {
  const ran = drops.filter(({ change }) => change !== null);
  const { domain, ticks } = decades([least_change, tolerance, ...ran.map(change_of)]);
  const label_x = chaotic ? "distance from the full model, up to the horizon (m)" : "added error (m)";
  const tick = (value: number) => (value <= least_change ? `\u2264 ${number(value, "", 1)}` : number(value, "", 1));
  return panel(drops, width, "Error added without each feature", { type: "log", domain, ticks, tickFormat: tick, label: label_x }, [
    ...(chaotic ? [] : [Plot.ruleX([tolerance], { stroke: "var(--ink)", strokeDasharray: "2 3" })]),
    Plot.ruleY(ran, { x1: domain[0], x2: change_of, y: label, stroke: colour, strokeOpacity: 0.4 }),
    Plot.dot(ran, { x: change_of, y: label, r: 4.5, fill: colour, className: "change" }),
    Plot.tip(ran, Plot.pointerY({ x: change_of, y: label, title: described, ...tip_look })),
  ]);
}

function ablation_chart({ drops, chaotic }: ModelCase, tolerance: number): HTMLElement {
  const judged = chaotic
    ? "Green: redundant, the statistics stay the same, whatever single motions do. Red: they differ, or a law is broken."
    : "Green: redundant, the error stays within the tolerance (dashed). Amber: it adds up to 1 cm. Red: more, or a law is broken.";
  return figure({
    title: "Without one feature",
    note: `${chaotic ? "How far single motions move apart" : "The error that its absence adds"}, and the remaining cost. ${judged}`,
    height: 120 + 2 * row_height * drops.length,
    draw: (width) => {
      const each = width > 900 ? Math.floor(width / 2) - 8 : width;
      return [error_panel(drops, each, tolerance, chaotic ?? false), cost_panel(drops, each)];
    },
  });
}

const cost_of = (value: number | null): string => (value === null ? "\u2013" : number(value * 1e6, "\u00b5s"));
const factor = ({ median, low, high }: Spread): string => `${number(median, "", 2)}\u00d7 (${number(low, "", 2)} \u2013 ${number(high, "", 2)})`;
const metres = (value: number | null): string => (value === null ? "\u2013" : number(value, "m", 2));
/** What a model adds; single motions say nothing where no two methods move alike. */
const added = ({ chaotic }: ModelCase, change: number | null): string => (chaotic ? "same statistics" : metres(change));
const name_of = ({ scenario, variant }: ModelCase): string => (variant ? `${scenario}, ${variant}` : scenario);

function overview(model: LeastModels): HTMLElement {
  const rows = model.cases.map((item) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, h("a", { href: `#${slug(item.scenario, item.variant)}` }, name_of(item))),
      h("td", { "data-label": "full model" }, cost_of(item.cost)),
      h("td", { "data-label": "least model" }, item.least ? h("strong", {}, factor(item.least.cheaper)) : "\u2013"),
      h("td", { "data-label": "added error" }, item.least ? added(item, item.least.change) : "\u2013"),
      h("td", { "data-label": "impulse:auto" }, item.least?.auto_cheaper ? factor(item.least.auto_cheaper) : "\u2013"),
      h("td", { "data-label": "as accurate" }, h("span", { class: "badge", "data-verdict": item.chosen?.within ? "right" : "wrong" }, item.chosen?.within ? "yes" : "no")),
    ),
  );
  return h(
    "section",
    { id: "overview" },
    h("h2", {}, "What each scene needs"),
    h(
      "p",
      { class: "lede" },
      `How many times cheaper than the full model, as the median over repetitions (and the middle half), for a model that is as good: plumb run calls nothing wrong that is right in the full model, and no error or overlap grows by more than ${number(Number(model.tolerance), "m", 1)} or, in chaotic scenes, the statistics stay the same. The least model was found by trial. impulse:auto chooses a model from the scene alone, before the run, and must be as good.`,
    ),
    table("The full model, the least model and impulse:auto", ["case", "full model, per second", "least model, cheaper", "added error", "impulse:auto, cheaper", "as accurate"], rows, "numbers"),
  );
}

function comparison(item: ModelCase): string {
  const until = `the first ${given(item.compared_until, "s", 3)}`;
  const full = `with the full model over ${item.compared_until < item.duration ? `${until}, after which runs that started 1 nm apart have diverged` : "the whole scene"}`;
  if (item.chaotic) {
    return `Chaotic: after ${given(item.compared_until, "s", 3)}, runs that started 1 nm apart have diverged, so no two methods move alike. Judged by statistics: a model is as good if eight runs of it and of the full model, from starts 1 nm apart, differ neither in energy nor in spread nor in rest time, by more than 5\u202f% of the energy lost, the spread and the duration, and bodies overlap no deeper, by more than 5\u202f% of the smallest.`;
  }
  if (!item.truth) return `There is no truth for this case: compared ${full}.`;
  const truth = item.truth === "converged" ? "a converged reference" : `the closed form \u201c${item.truth}\u201d`;
  if (item.compared_until === 0) return `Compared with ${truth}.`;
  return `Compared with ${truth} for the first ${given(item.truth_until, "s", 3)}, and ${full}.`;
}

const because = ({ different, breaks }: Drop): string => [different, breaks && `breaks ${breaks}`].filter(Boolean).map((one) => `: ${one}`).join("");

function drops_table(drops: Drop[]): HTMLElement {
  const rows = drops.map((drop) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, drop.feature),
      h("td", { "data-label": "without" }, drop.without),
      h("td", { "data-label": "setting" }, drop.setting),
      h("td", { "data-label": "added error" }, drop.change === null ? drop.why || "does not run" : metres(drop.change)),
      h("td", { "data-label": "cost" }, drop.ratio === null ? "\u2013" : number(drop.ratio, "", 2)),
      h("td", { "data-label": "redundant" }, drop.within ? "yes" : `no${because(drop)}`),
    ),
  );
  return table("Without one feature", ["feature", "without", "setting", "added error", "cost, full = 1", "redundant"], rows);
}

/** What a coarser question would allow, each with its command. */
function coarser_of(item: ModelCase, dt: string): HTMLElement | null {
  if (!item.coarser.length) return null;
  const lines = item.coarser.flatMap(({ tolerance, line, cheaper, change }) => [
    h("p", {}, `If ${number(tolerance * 1000, "mm", 1)} may be lost: ${number(cheaper, "", 2)} times cheaper, adds ${metres(change)}`),
    command(run_command({ scenario: item.scenario, variant: item.variant, engine: line, setting: "", dt })),
  ]);
  return h("div", {}, ...lines);
}

function no_least({ why }: ModelCase): string {
  const cure = why.includes("timed out") ? " Give it more with --time-limit." : "";
  return `No least model was found: ${why || "the search did not end"}.${cure}`;
}

function least_of(item: ModelCase, dt: string): HTMLElement {
  if (!item.least) return h("p", { class: "absence" }, no_least(item));
  const { line, dropped, cheaper, change } = item.least;
  const cut = item.complete ? "" : " The search ran out of time: it may not be the least; --time-limit gives it more.";
  if (!dropped.length) {
    const none = item.complete ? "No feature that costs time is redundant: the full model is the least." : "No cheaper model was found in time.";
    return h("p", {}, `${none}${cut}`);
  }
  const removed = dropped.map(({ feature, without }) => h("li", {}, h("strong", {}, feature), `: without ${without}`));
  return h(
    "div",
    { class: "least" },
    h("p", {}, `The least model costs ${number(1 / cheaper.median, "", 2)} of the full model and ${item.chaotic ? "has the same statistics" : `adds an error of ${metres(change)}`}.${cut} It leaves out`),
    h("ul", {}, ...removed),
    command(run_command({ scenario: item.scenario, variant: item.variant, engine: line, setting: "", dt })),
  );
}

function choice_of({ chosen }: ModelCase): HTMLElement | null {
  if (!chosen) return null;
  if (!chosen.choices.length) return h("p", {}, "impulse:auto leaves nothing out here: the scene alone does not show what is redundant.");
  const reasons = chosen.choices.map(({ setting, reason }) => h("li", {}, h("strong", {}, setting), `: ${reason}`));
  return h("div", {}, h("p", {}, "impulse:auto chooses"), h("ul", {}, ...reasons));
}

function case_section(model: LeastModels, item: ModelCase): HTMLElement {
  return h(
    "article",
    { id: slug(item.scenario, item.variant), class: "case" },
    h("h3", {}, name_of(item)),
    h("p", {}, `${comparison(item)}${item.error === null ? "" : ` The error of the full model is ${metres(item.error)}.`}`),
    least_of(item, model.dt),
    coarser_of(item, model.dt),
    item.drops.length ? ablation_chart(item, Number(model.tolerance)) : null,
    choice_of(item),
    item.drops.length ? folded("Each feature in numbers", () => [drops_table(item.drops)]) : null,
  );
}

/** "rain, count=50: impulse:solver=soft-step is 15 times cheaper than the full model", or a range over several cases. */
function sentence(model: LeastModels): string {
  const [only, ...others] = model.cases;
  if (!only) return "No case was measured.";
  const found = model.cases.flatMap((item) => (item.least?.dropped.length ? [{ item, least: item.least }] : []));
  const kept = model.cases.filter(({ chosen }) => chosen?.within).length;
  const cut = model.cases.filter(({ complete, least }) => !complete || !least).length;
  const unknown = cut ? `; ${others.length ? `in ${count(cut, "case")} ` : ""}the search ran out of time` : "";
  const accurate = `impulse:auto is as accurate as the full model in ${kept} of ${count(model.cases.length, "case")}`;
  const [first] = found;
  if (!others.length) {
    if (!only.least) return `${name_of(only)}: ${no_least(only)}`;
    if (!first) return `${name_of(only)}: ${only.complete ? "the full model is the least" : "no cheaper model was found"}${unknown}.`;
    return `${name_of(only)}: ${first.least.line} is ${number(first.least.cheaper.median, "", 2)} times cheaper than the full model and as good${unknown}.`;
  }
  const factors = found.map(({ least }) => least.cheaper.median).sort((a, b) => a - b);
  const none = model.cases.length - cut - found.length;
  const range = factors.length > 1 ? `${number(factors[0], "", 2)} to ${number(factors[factors.length - 1], "", 2)}` : number(factors[0], "", 2);
  const result = factors.length
    ? `A smaller model, as good as the full one, is ${range} times cheaper in ${count(found.length, "case")}${none > 0 ? `; in ${none} the full one is the least` : ""}`
    : "No smaller model is as good as the full one";
  return `${result}${unknown}; ${accurate}.`;
}

export function model(study: Study): StudyView {
  const all = least_models(study);
  const scenarios = [...new Set(all.cases.map(({ scenario }) => scenario))];
  return {
    sentence: sentence(all),
    sections: [
      { id: "overview", name: "What each scene needs", content: () => overview(all) },
      ...scenarios.map((name) => ({
        id: slug(name),
        name,
        content: () => h(
          "section",
          { id: slug(name), class: "chapter" },
          h("h2", {}, name),
          ...all.cases.filter(({ scenario }) => scenario === name).map((item) => case_section(all, item)),
        ),
      })),
    ],
  };
}
