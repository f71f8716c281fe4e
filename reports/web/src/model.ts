// The report as the page shows it: engines with their colours and shapes, and cases (one variant of a scenario) with
// their runs, comparisons, timings and replays.
import { series_of, type Comparison, type Curves, type EngineNote, type InvariantCheck, type KeyDifferences, type Page, type Run, type ScenarioNote, type Series, type Timing, type TruthCheck } from "./data";
import { look_of } from "./looks";
import type { Replay } from "./replay/data";

export interface Engine {
  label: string; // as --engine takes it; "truth" for all closed forms
  engine: string;
  method: string;
  exact: boolean;
  execution: string; // how its code runs, by which times are told apart; "" where no times are compared
  color: string;
  symbol: string;
  dash: string;
}

export interface Entry {
  engine: Engine;
  run: Run;
  series: Series | undefined; // once they are loaded
  timing: Timing | undefined;
  worst: number; // largest error / tolerance of the truth checks and invariants; NaN if nothing is judged
  farthest: number; // largest error / scale of the truth checks; NaN if there is none
}

export interface Case {
  scenario: string;
  variant: string;
  parameters: Record<string, number>;
  entries: Entry[]; // the truth comes last
  comparisons: Comparison[];
  curves: Curves | undefined;
  replay: Replay | undefined;
  horizon: number | undefined; // s, up to which single runs are compared; undefined: to the end
}

/** What a replay needs of a case. */
export interface Replayed extends Pick<Case, "scenario" | "variant" | "comparisons" | "replay"> {
  entries: { engine: Engine; run: Pick<Run, "engine" | "method" | "exact" | "status"> }[];
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

export const truth_look = { color: "var(--truth)", symbol: "times", dash: "1 4" };

/** How an engine's code runs, where that is not native: "WebAssembly", or "program" for one that does not say. */
export const mark_of = ({ execution }: Pick<Engine, "execution">): string =>
  execution === "native" ? "" : execution === "not stated" ? "program" : execution;

/** The label, and how its code runs where that is not native: where times are compared. */
export const timed_label = (engine: Pick<Engine, "label" | "execution">): string => {
  const mark = mark_of(engine);
  return mark ? `${engine.label} (${mark})` : engine.label;
};

/** What a factor between the times of these engines needs to be read with; "" if their code runs alike. */
export const unlike = (engines: Pick<Engine, "execution">[]): string =>
  new Set(engines.map(({ execution }) => execution)).size > 1
    ? "Native, WebAssembly, JIT-compiled and interpreted code: factors between them are not of the methods alone."
    : "";

function engines_of(runs: Run[], notes: EngineNote[]): Engine[] {
  const found = new Map<string, Engine>();
  const ours_first = [...runs].sort((a, b) => Number(b.engine === "impulse") - Number(a.engine === "impulse"));
  for (const run of ours_first) {
    const label = run.exact ? "truth" : label_of(run);
    if (found.has(label)) continue;
    found.set(label, {
      label,
      engine: run.engine,
      method: run.method,
      exact: run.exact,
      execution: notes.find(({ name }) => name === run.engine)?.execution ?? "not stated",
      ...(run.exact ? truth_look : look_of(label)),
    });
  }
  return [...found.values()].sort((a, b) => Number(a.exact) - Number(b.exact));
}

/** error / tolerance of a check; infinite for a tolerance of 0 or an error that is not finite. */
export const ratio_of = ({ ratio }: TruthCheck | InvariantCheck): number => ratio ?? Infinity;

function worst(run: Run): number {
  const truth = reported(run).map(ratio_of);
  const invariants = run.invariants.filter(is_judged).map(ratio_of);
  const all = [...truth, ...invariants];
  return all.length ? Math.max(...all) : NaN;
}

/** Whether an invariant was held or broken. */
export const is_judged = ({ status }: InvariantCheck): boolean => status === "held" || status === "broken";

/** error / scale of a check; infinite for an unknown scale or an error that is not finite. */
export const relative_of = ({ relative_error }: TruthCheck): number => relative_error ?? Infinity;

export const reported = (run: Run): TruthCheck[] => run.truth.filter((check) => check.reported);

function farthest(run: Run): number {
  const all = reported(run).map(relative_of);
  return all.length ? Math.max(...all) : NaN;
}

const key = (...parts: string[]): string => JSON.stringify(parts);
const run_key = (of: { scenario: string; variant: string; engine: string; method: string }): string =>
  key(of.scenario, of.variant, of.engine, of.method);

export function model_of(page: Page): Model {
  const { report } = page;
  const engines = engines_of(report.runs, report.engines);
  const by_label = new Map(engines.map((engine) => [engine.label, engine]));
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
    let item = cases.get(case_key);
    if (!item) {
      const comparisons = report.comparisons.filter((c) => c.scenario === run.scenario && c.variant === run.variant);
      const horizons = comparisons.map(({ metrics }) => metrics["horizon"]?.value);
      item = {
        scenario: run.scenario,
        variant: run.variant,
        parameters: run.parameters,
        entries: [],
        comparisons,
        curves: page.curves.find(({ scenario, variant }) => scenario === run.scenario && variant === run.variant),
        replay: page.replays.find((replay) => replay.scenario === run.scenario && replay.variant === run.variant),
        horizon: horizons.find((value) => typeof value === "number"),
      };
      cases.set(case_key, item);
      chapter.cases.push(item);
    }
    item.entries.push({ engine, run, series: undefined, timing: timings.get(run_key(run)), worst: worst(run), farthest: farthest(run) });
  }
  const order = new Map(engines.map((engine, index) => [engine, index]));
  for (const item of cases.values()) {
    item.entries.sort((a, b) => (order.get(a.engine) ?? 0) - (order.get(b.engine) ?? 0));
  }
  return { page, engines, chapters: [...chapters.values()] };
}

/** Unpacks the series of a case; throws if they are damaged. */
export function load_series({ curves, entries }: Case): void {
  const series = new Map((curves ? series_of(curves) : []).map((item) => [run_key(item), item]));
  for (const entry of entries) entry.series = series.get(run_key(entry.run));
}

/** How far apart the runs of two engines are in a case, and when each came to rest. */
export interface Apart {
  key: KeyDifferences | null; // null unless both runs reached their end
  reason: string;
}

const run_label = ({ engine, run }: Entry): string => (engine.exact ? label_of(run) : engine.label);

/** undefined unless both engines ran the case. */
export function apart(item: Case, a: Engine, b: Engine): Apart | undefined {
  const name = (engine: Engine): string | undefined => item.entries.filter((entry) => entry.engine === engine).map(run_label)[0];
  const [of_a, of_b] = [name(a), name(b)];
  if (of_a === undefined || of_b === undefined) return undefined;
  const straight = item.comparisons.find((one) => one.a === of_a && one.b === of_b);
  if (straight) return { key: straight.key_differences, reason: straight.reason };
  const turned = item.comparisons.find((one) => one.a === of_b && one.b === of_a);
  if (!turned) return undefined;
  const key = turned.key_differences;
  const swapped = key && { ...key, rest_a: key.rest_b, rest_b: key.rest_a, overlap_a: key.overlap_b, overlap_b: key.overlap_a };
  return { key: swapped, reason: turned.reason };
}

/** s, since when all bodies of a run are at rest; null if one moves at the end, undefined if it is not known. */
export function rest_of(item: Case, entry: Entry): number | null | undefined {
  for (const other of item.entries) {
    const key = apart(item, entry.engine, other.engine)?.key;
    if (key) return key.rest_a;
  }
  return entry.run.metrics["time_to_rest"]?.value;
}

/** What the page of a study consists of: its result in one sentence, and its sections. */
export interface StudyView {
  sentence: string;
  sections: { id: string; name: string; content: () => HTMLElement }[];
}
