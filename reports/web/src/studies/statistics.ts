// The statistics study: for each number the interval of its mean by every engine, beside what mechanics says of it.
import * as Plot from "@observablehq/plot";
import { figure } from "../charts/figure";
import { name_axis, plot_look, tip_look } from "../charts/look";
import type { Study } from "../data";
import { timed_label, type StudyView } from "../model";
import { h, slug, table } from "../dom";
import { folded } from "../folded";
import { count, enumerate, given, number, words } from "../format";

interface Statistic {
  name: string;
  unit: string;
  low: number;
  high: number;
  resolution: number;
  source: string;
  idealisation: boolean;
}

type Verdict = "agrees" | "differs" | "undecided";

interface Finding {
  engine: string;
  control: boolean;
  statistic: string;
  idealisation: boolean;
  draws: number;
  mean: number;
  low: number;
  high: number;
  verdict: Verdict;
  off: number | null; // standard errors; null: infinitely many
  needed: number; // draws, if undecided
}

interface Ensemble {
  name: string;
  question: string;
  dt: number;
  control: string;
  control_about: string;
  statistics: Statistic[];
  results: Finding[];
  unjudged: { engine: string; status: string; why: string }[];
}

interface Tally {
  engine: string;
  agrees: number;
  differs: number;
  undecided: number;
  unjudged: number;
}

interface Statistics {
  miss: number;
  looks: number;
  summary: Tally[];
  ensembles: Ensemble[];
}

interface Cost {
  ensemble: string;
  engine: string;
  execution: string;
  seconds: number;
}

const row_height = 24; // px
const colours: Record<Verdict, string> = { agrees: "var(--right)", differs: "var(--wrong)", undecided: "var(--coarse)" };

const band_text = ({ low, high, unit }: Statistic): string => (low === high ? given(low, unit, 4) : `${given(low, "", 4)} to ${given(high, unit, 4)}`);

function verdict_text({ verdict, off, needed }: Finding): string {
  if (verdict === "differs") return off === null ? "differs" : `differs by ${count(Number(off.toPrecision(3)), "standard error")}`;
  return verdict === "undecided" ? `undecided, about ${needed} draws needed` : verdict;
}

const interval_text = ({ mean, low, high }: Finding, { unit }: Statistic): string => `${number(mean, unit)} (${number(low, "", 3)} to ${number(high, unit, 3)})`;

function chart(statistic: Statistic, found: Finding[], width: number): Element {
  const names = found.map(({ engine }) => engine);
  const { marginLeft, axis } = name_axis(width, names);
  const tip = (one: Finding) => [`${one.engine}: ${interval_text(one, statistic)}`, `${count(one.draws, "draw")}: ${verdict_text(one)}`].join("\n");
  const band = statistic.low === statistic.high ? Plot.ruleX([statistic.low], { stroke: "var(--ink)", strokeDasharray: "2 3" }) : Plot.rect([statistic], { x1: "low", x2: "high", fill: "var(--right-wash)", stroke: "var(--right)", strokeDasharray: "2 3" });
  return Plot.plot({
    ...plot_look(width, 64 + row_height * names.length),
    marginLeft,
    ariaLabel: statistic.name,
    x: { grid: true, label: `${statistic.name}${statistic.unit ? ` (${statistic.unit})` : ""}`, labelAnchor: "right", nice: true },
    y: { type: "point", domain: names, padding: 0.5 },
    marks: [
      band,
      axis,
      Plot.ruleY(found, { x1: "low", x2: "high", y: "engine", stroke: ({ verdict }: Finding) => colours[verdict], strokeWidth: 3, strokeOpacity: 0.55 }),
      Plot.dot(found, { x: "mean", y: "engine", fill: ({ verdict }: Finding) => colours[verdict], r: 4.5, className: "means" }),
      Plot.tip(found, Plot.pointerY({ x: "mean", y: "engine", title: tip, ...tip_look })),
    ],
  });
}

const found_in = ({ results }: Ensemble, { name }: Statistic): Finding[] => results.filter(({ statistic }) => statistic === name);

function statistic_figure(ensemble: Ensemble, statistic: Statistic): HTMLElement | null {
  const found = found_in(ensemble, statistic);
  if (!found.length) return null;
  const idealised = statistic.idealisation ? " An idealisation: to differ from it is no fault of an engine." : "";
  return figure({
    title: statistic.name,
    note: `Expected: ${band_text(statistic)}, ${statistic.source}.${idealised}`,
    height: 64 + row_height * found.length,
    draw: (width) => [chart(statistic, found, width)],
  });
}

function numbers(ensemble: Ensemble): HTMLElement {
  const heads = ["statistic", "expected", "engine", "mean and its interval", "draws", "verdict"];
  const rows = ensemble.statistics.flatMap((statistic) =>
    found_in(ensemble, statistic).map((one) => {
      const cells = [band_text(statistic), one.engine, interval_text(one, statistic), String(one.draws), verdict_text(one)];
      return h("tr", {}, h("th", { scope: "row" }, statistic.name), ...cells.map((text, index) => h("td", { "data-label": heads[index + 1] }, text)));
    }),
  );
  return folded("Numbers", () => [table(`Means in ${words(ensemble.name)}`, heads, rows, "numbers")]);
}

function costs_of(ensemble: Ensemble, costs: Cost[]): HTMLElement | null {
  const own = costs.filter((cost) => cost.ensemble === ensemble.name);
  if (!own.length) return null;
  return h("p", { class: "absence" }, `Computing time of a run: ${enumerate(own.map(({ engine, execution, seconds }) => `${timed_label({ label: engine, execution })} ${number(seconds, "s", 2)}`))}.`);
}

function ensemble_section(ensemble: Ensemble, costs: Cost[]): HTMLElement {
  return h(
    "section",
    { id: slug(ensemble.name), class: "chapter" },
    h("h2", {}, words(ensemble.name)),
    h("p", { class: "lede" }, ensemble.question),
    h(
      "article",
      { class: "case" },
      h("div", { class: "charts" }, ...ensemble.statistics.map((statistic) => statistic_figure(ensemble, statistic))),
      ...ensemble.unjudged.map(({ engine, status, why }) => h("p", { class: "absence" }, `${engine}: ${status}${why ? `, ${why}` : ""}.`)),
      costs_of(ensemble, costs),
      numbers(ensemble),
    ),
  );
}

/** Over all statistics of an ensemble that are no idealisations: the worst verdict. */
function worst(ensemble: Ensemble, engine: string): Verdict | null {
  const own = ensemble.results.filter((one) => one.engine === engine && !one.idealisation).map(({ verdict }) => verdict);
  return (["differs", "undecided", "agrees"] as const).find((verdict) => own.includes(verdict)) ?? null;
}

function overall({ miss, looks, summary, ensembles }: Statistics): HTMLElement {
  const heads = ensembles.map(({ name }) => h("a", { href: `#${slug(name)}` }, words(name)));
  const rows = summary.map(({ engine }) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, engine),
      ...ensembles.map((ensemble) => {
        const verdict = worst(ensemble, engine);
        return h("td", { "data-label": words(ensemble.name), class: verdict ? "" : "none", style: verdict ? `color: ${colours[verdict]}` : "" }, verdict ?? "\u2013");
      }),
    ),
  );
  return h(
    "section",
    { id: "verdicts" },
    h("h2", {}, "Verdicts"),
    h(
      "p",
      { class: "lede" },
      `Agrees: the interval of the mean touches what mechanics says and is narrow enough to tell. Differs: it lies outside. Undecided: it is too wide. All ${count(looks, "interval")} together hold with ${given(100 * (1 - miss), "%")}; a cell has the worst verdict of its ensemble.`,
    ),
    table("The worst verdict of each engine in each ensemble", ["engine", ...heads], rows),
  );
}

function sentence({ summary }: Statistics): string {
  const judged = ({ agrees, differs, undecided }: Tally): number => agrees + differs + undecided;
  const parts = summary.map((one, index) => (index ? `${one.engine} in ${one.agrees} of ${judged(one)}` : `${one.engine} agrees with mechanics in ${one.agrees} of ${count(judged(one), "statistic")}`));
  return parts.length ? `${parts.join(", ")}.` : "No statistics.";
}

export function statistics(study: Study): StudyView {
  const found = study.findings as unknown as Statistics;
  const costs = (study.timings.costs ?? []) as unknown as Cost[];
  return {
    sentence: sentence(found),
    sections: [
      { id: "verdicts", name: "Verdicts", content: () => overall(found) },
      ...found.ensembles.map((ensemble) => ({ id: slug(ensemble.name), name: words(ensemble.name), content: () => ensemble_section(ensemble, costs) })),
    ],
  };
}
