// What each feature is worth in one case: how much worse and how much cheaper the model is without it.
// What a scene needs of the engine: its least model, what each feature is worth, and whether the engine's own choice
// keeps its promise.
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
const least_change = 1e-9; // m; smaller ones are drawn there

const label = ({ setting }: Drop): string => setting.replaceAll(/(integrator|solver)=/g, "").replaceAll(",", ", ");
const colour = ({ within }: Drop): string => (within ? "var(--right)" : "var(--wrong)");
const change_of = ({ change }: Drop): number => Math.max(least_change, change ?? Infinity);

const described = (drop: Drop): string =>
  [
    `${drop.feature}: without ${drop.without}`,
    drop.setting,
    drop.change === null ? drop.why || "does not run to the end" : `worse by ${number(drop.change, "m", 2)}`,
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

function error_panel(drops: Drop[], width: number, tolerance: number): Element {
  const ran = drops.filter(({ change }) => change !== null);
  const { domain, ticks } = decades([least_change, tolerance, ...ran.map(change_of)]);
  const foot = (value: number) => (value <= least_change ? `\u2264 ${number(value, "", 1)}` : number(value, "", 1));
  return panel(drops, width, "Error added without each feature", { type: "log", domain, ticks, tickFormat: foot, label: "worse by (m)" }, [
    Plot.ruleX([tolerance], { stroke: "var(--ink)", strokeDasharray: "2 3" }),
    Plot.ruleY(ran, { x1: domain[0], x2: change_of, y: label, stroke: colour, strokeOpacity: 0.4 }),
    Plot.dot(ran, { x: change_of, y: label, r: 4.5, fill: colour, className: "change" }),
    Plot.tip(ran, Plot.pointerY({ x: change_of, y: label, title: described, ...tip_look })),
  ]);
}

export function ablation_chart({ drops }: ModelCase, tolerance: number): HTMLElement {
  return figure({
    title: "Without one feature",
    note: "What the model is worse by, and what it then costs. Green stays within the tolerance (dashed) and may go; red may not.",
    height: 120 + 2 * row_height * drops.length,
    draw: (width) => {
      const each = width > 900 ? Math.floor(width / 2) - 8 : width;
      return [error_panel(drops, each, tolerance), cost_panel(drops, each)];
    },
  });
}

const cost_of = (value: number | null): string => (value === null ? "\u2013" : number(value * 1e6, "\u00b5s"));
const factor = ({ median, low, high }: Spread): string => `${number(median, "", 2)}\u00d7 (${number(low, "", 2)} \u2013 ${number(high, "", 2)})`;
const metres = (value: number | null): string => (value === null ? "\u2013" : number(value, "m", 2));
const name_of = ({ scenario, variant }: ModelCase): string => (variant ? `${scenario}, ${variant}` : scenario);

function overview(model: LeastModels): HTMLElement {
  const rows = model.cases.map((place) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, h("a", { href: `#${slug(place.scenario, place.variant)}` }, name_of(place))),
      h("td", { "data-label": "full model" }, cost_of(place.cost)),
      h("td", { "data-label": "least model" }, place.least ? h("strong", {}, factor(place.least.cheaper)) : "\u2013"),
      h("td", { "data-label": "worse by" }, place.least ? metres(place.least.change) : "\u2013"),
      h("td", { "data-label": "impulse:auto" }, place.least ? factor(place.least.auto_cheaper) : "\u2013"),
      h("td", { "data-label": "its promise" }, h("span", { class: "badge", "data-verdict": place.chosen?.within ? "right" : "wrong" }, place.chosen?.within ? "kept" : "broken")),
    ),
  );
  return h(
    "section",
    { id: "overview" },
    h("h2", {}, "What scenes need"),
    h(
      "p",
      { class: "lede" },
      `Times cheaper than the full model, turn by turn (middle half of the turns), where nothing gets worse by more than ${number(Number(model.tolerance), "m", 1)}. The least model was found by trying; impulse:auto chooses beforehand, from the scene alone, and promises never to be less accurate.`,
    ),
    table("The full model, the least and the engine\u2019s own choice", ["case", "full model, per second", "least model, cheaper", "worse by", "impulse:auto, cheaper", "its promise"], rows, "numbers"),
  );
}

function weighed(place: ModelCase): string {
  const until = `the first ${given(place.compared_until, "s", 3)}`;
  const full = `by the difference from the full model over ${place.compared_until < place.duration ? `${until}; beyond, runs that began a billionth apart have parted` : "the whole scene"}`;
  if (!place.truth) return `No truth is known here: weighed ${full}.`;
  const truth = place.truth === "converged" ? "a converged reference" : `the closed form \u201c${place.truth}\u201d`;
  if (place.compared_until === 0) return `Weighed against ${truth}.`;
  return `Weighed against ${truth} for the first ${given(place.truth_until, "s", 3)}, and ${full}.`;
}

function drops_table(drops: Drop[]): HTMLElement {
  const rows = drops.map((drop) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, drop.feature),
      h("td", { "data-label": "without" }, drop.without),
      h("td", { "data-label": "setting" }, drop.setting),
      h("td", { "data-label": "worse by" }, drop.change === null ? drop.why || "does not run" : metres(drop.change)),
      h("td", { "data-label": "cost" }, drop.ratio === null ? "\u2013" : number(drop.ratio, "", 2)),
      h("td", { "data-label": "may go" }, drop.within ? "yes" : "no"),
    ),
  );
  return table("Each feature alone", ["feature", "without", "setting", "worse by", "cost, full = 1", "may go"], rows);
}

function least_of(place: ModelCase, dt: string): HTMLElement {
  if (!place.least) return h("p", { class: "absence" }, "No least model was found: the full one does not run to the end.");
  const { line, dropped, cheaper, change } = place.least;
  if (!dropped.length) return h("p", {}, "Nothing that costs anything may go: the full model is the least.");
  const gone = dropped.map(({ feature, without }) => h("li", {}, h("strong", {}, feature), `: without ${without}`));
  return h(
    "div",
    { class: "least" },
    h("p", {}, `The least model costs ${number(1 / cheaper.median, "", 2)} of the full one and is worse by ${metres(change)}. It does without`),
    h("ul", {}, ...gone),
    command(run_command({ scenario: place.scenario, variant: place.variant, engine: line, setting: "", dt })),
  );
}

function choice_of({ chosen }: ModelCase): HTMLElement | null {
  if (!chosen) return null;
  if (!chosen.choices.length) return h("p", {}, "impulse:auto leaves nothing out here: the scene alone does not show that it could.");
  const reasons = chosen.choices.map(({ setting, reason }) => h("li", {}, h("strong", {}, setting), `: ${reason}`));
  return h("div", {}, h("p", {}, "impulse:auto chooses"), h("ul", {}, ...reasons));
}

function case_section(model: LeastModels, place: ModelCase): HTMLElement {
  return h(
    "article",
    { id: slug(place.scenario, place.variant), class: "case" },
    h("h3", {}, name_of(place)),
    h("p", {}, `${weighed(place)}${place.error === null ? "" : ` The full model is ${metres(place.error)} off.`}`),
    least_of(place, model.dt),
    place.drops.length ? ablation_chart(place, Number(model.tolerance)) : null,
    choice_of(place),
    place.drops.length ? folded("Each feature, in words and numbers", () => [drops_table(place.drops)]) : null,
  );
}

function sentence(model: LeastModels): string {
  const found = model.cases.flatMap(({ least }) => least ?? []);
  const factors = found.map(({ cheaper }) => cheaper.median).sort((a, b) => a - b);
  const kept = model.cases.filter(({ chosen }) => chosen?.within).length;
  const range = factors.length
    ? `The least model that answers as well is ${number(factors[0], "", 2)} to ${number(factors[factors.length - 1], "", 2)} times cheaper than the full one`
    : "No least model was found";
  return `${range}, over ${count(model.cases.length, "case")}; impulse:auto keeps its promise in ${kept === model.cases.length ? "all of them" : `${kept} of them`}.`;
}

export function model(study: Study): StudyView {
  const all = least_models(study);
  const scenarios = [...new Set(all.cases.map(({ scenario }) => scenario))];
  return {
    sentence: sentence(all),
    sections: [
      { id: "overview", name: "What scenes need", content: () => overview(all) },
      ...scenarios.map((name) => ({
        id: slug(name),
        name,
        content: () => h(
          "section",
          { id: slug(name), class: "chapter" },
          h("h2", {}, name),
          ...all.cases.filter(({ scenario }) => scenario === name).map((place) => case_section(all, place)),
        ),
      })),
    ],
  };
}
