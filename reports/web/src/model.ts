// The report as the page thinks of it: engines with a look of their own, and cases (a scenario in one variant) with
// everything that is known about them.
import type { Comparison, InvariantCheck, Page, Run, ScenarioNote, Series, Timing, TruthCheck } from "./data";
import type { Replay } from "./replay/data";

export interface Engine {
  label: string; // as --engine takes it; "truth" for the closed forms
  engine: string;
  method: string;
  exact: boolean;
  color: string;
  symbol: string;
  dash: string;
}

export interface Entry {
  engine: Engine;
  run: Run;
  series: Series | undefined;
  timing: Timing | undefined;
  worst: number; // largest miss, of a truth or an invariant, as a share of what is allowed; NaN where nothing is judged
}

export interface Case {
  scenario: string;
  variant: string;
  parameters: Record<string, number>;
  entries: Entry[]; // the truth last
  comparisons: Comparison[];
  replay: Replay | undefined;
  horizon: number | undefined; // s, up to which the scene can be told point by point; undefined: to its end
}

export interface Chapter {
  name: string;
  note: ScenarioNote | undefined;
  cases: Case[];
}

export interface Model {
  page: Page;
  engines: Engine[];
  chapters: Chapter[];
}

export const label_of = (of: { engine: string; method: string }): string => (of.method ? `${of.engine}:${of.method}` : of.engine);

// Told apart three ways at once: by colour (a palette that survives every common colour blindness), shape and dash.
const symbols = ["circle", "square", "triangle", "diamond", "wye", "star"];
const dashes = ["", "7 3", "2 3", "9 3 2 3", "12 4", "4 2"];
const colors = 6;

/** Of the index-th engine; the first 36 differ. */
export function look(index: number): Pick<Engine, "color" | "symbol" | "dash"> {
  const turn = index + Math.floor(index / colors);
  return {
    color: `var(--engine-${(index % colors) + 1})`,
    symbol: symbols[turn % symbols.length] ?? "circle",
    dash: dashes[turn % dashes.length] ?? "",
  };
}

function engines_of(runs: Run[]): Engine[] {
  const found = new Map<string, Engine>();
  const first_ours = [...runs].sort((a, b) => Number(b.engine === "impulse") - Number(a.engine === "impulse"));
  let index = 0;
  for (const run of first_ours) {
    const label = run.exact ? "truth" : label_of(run);
    if (found.has(label)) continue;
    found.set(label, {
      label,
      engine: run.engine,
      method: run.method,
      exact: run.exact,
      ...(run.exact ? { color: "var(--truth)", symbol: "times", dash: "1 4" } : look(index++)),
    });
  }
  return [...found.values()].sort((a, b) => Number(a.exact) - Number(b.exact));
}

export function ratio(check: TruthCheck): number {
  if (check.error === null || check.tolerance === null) return Infinity;
  if (check.error === 0) return 0;
  return check.tolerance > 0 ? check.error / check.tolerance : Infinity;
}

export const law_ratio = (check: InvariantCheck): number => check.ratio ?? Infinity;

function worst(run: Run): number {
  const readings = run.truth.filter((check) => check.reported).map(ratio);
  const laws = run.invariants.filter(({ status }) => status !== "not reported").map(law_ratio);
  const all = [...readings, ...laws];
  return all.length ? Math.max(...all) : NaN;
}

const key = (...parts: string[]): string => JSON.stringify(parts);
const run_key = (of: { scenario: string; variant: string; engine: string; method: string }): string =>
  key(of.scenario, of.variant, of.engine, of.method);

export function model_of(page: Page): Model {
  const { report } = page;
  const engines = engines_of(report.runs);
  const by_label = new Map(engines.map((engine) => [engine.label, engine]));
  const series = new Map(page.series.map((item) => [run_key(item), item]));
  const timings = new Map(report.timings.steps.map((item) => [run_key(item), item]));

  const chapters = new Map<string, Chapter>();
  const cases = new Map<string, Case>();
  for (const run of report.runs) {
    const engine = by_label.get(run.exact ? "truth" : label_of(run));
    if (!engine) continue;
    let chapter = chapters.get(run.scenario);
    if (!chapter) {
      chapter = { name: run.scenario, note: report.scenarios.find(({ name }) => name === run.scenario), cases: [] };
      chapters.set(run.scenario, chapter);
    }
    const case_key = key(run.scenario, run.variant);
    let place = cases.get(case_key);
    if (!place) {
      const comparisons = report.comparisons.filter((c) => c.scenario === run.scenario && c.variant === run.variant);
      const horizons = comparisons.map(({ metrics }) => metrics["horizon"]?.value);
      place = {
        scenario: run.scenario,
        variant: run.variant,
        parameters: run.parameters,
        entries: [],
        comparisons,
        replay: page.replays.find((replay) => replay.scenario === run.scenario && replay.variant === run.variant),
        horizon: horizons.find((value) => typeof value === "number"),
      };
      cases.set(case_key, place);
      chapter.cases.push(place);
    }
    const found = { series: series.get(run_key(run)), timing: timings.get(run_key(run)) };
    place.entries.push({ engine, run, worst: worst(run), ...found });
  }
  const order = new Map(engines.map((engine, index) => [engine, index]));
  for (const place of cases.values()) {
    place.entries.sort((a, b) => (order.get(a.engine) ?? 0) - (order.get(b.engine) ?? 0));
  }
  return { page, engines, chapters: [...chapters.values()] };
}
