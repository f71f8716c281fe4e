// The findings of the speed study, as its view uses them.
import type { Study } from "../data";
import { number } from "../format";
import { look_of } from "../looks";
import { label_of, type Engine } from "../model";

export interface Reading {
  value: number;
  bound: boolean; // an upper bound: the front ends here
}

export interface SpeedMark {
  key: string;
  engine: Engine;
  setting: string;
  dt: number;
  time: number; // s per simulated second
  low: number;
  high: number;
  wide: boolean; // the repetitions scatter too much
  error: number; // m
  on_front: boolean; // of its own engine
}

export interface SpeedCurve {
  engine: Engine;
  front: SpeedMark[];
  time_for_error: (Reading | null)[];
  time_for_scale: (Reading | null)[];
  error_for_time: (Reading | null)[];
  least_error: number | null; // m; null if it never ran to the end
}

export interface SpeedCase {
  scenario: string;
  variant: string;
  truth: string;
  truth_error: number; // m
  scale: number; // m, how far the bodies move
  phases: number;
  timed: number; // s of the scene
  marks: SpeedMark[];
  curves: SpeedCurve[];
  front: SpeedMark[]; // of all
}

export interface OrderRow {
  scenario: string;
  variant: string;
  engine: string;
  option: string;
  setting: string;
  standard: boolean;
  stated: number | null;
  order: number | null;
  half_width: number | null;
  points: number;
  finding: string;
}

export interface SpeedModel {
  order_tolerance: number;
  error_targets: number[]; // m
  scale_targets: number[]; // of the case's scale
  time_targets: number[];
  cases: SpeedCase[];
  orders: OrderRow[];
  without_truth: string[];
  failures: Failure[];
}

/** An engine that failed in some jobs, which the tables then lack. */
export interface Failure {
  engine: string;
  failed: number; // jobs
  jobs: number;
  first: string; // of them
  why: string;
}

interface Values {
  scenario: string;
  variant: string;
  engine: string;
  method: string;
  option: string;
  setting: string;
  dt: number;
  status: string;
  truth: string;
  truth_error: number;
  phases: number;
  timed: number;
  error: number | null;
}

interface Timings {
  error_targets: number[];
  scale_targets: number[];
  time_targets: number[];
  cases: {
    scenario: string;
    variant: string;
    front: string[];
    scale: number;
    engines: { engine: string; execution: string; front: string[]; time_for_error: (Reading | null)[]; time_for_scale: (Reading | null)[]; error_for_time: (Reading | null)[]; least_error: number | null }[];
  }[];
}

interface Time {
  median: number;
  low: number;
  high: number;
  wide: boolean;
}

export function speed_model(study: Study): SpeedModel {
  const timings = study.timings as unknown as Timings;
  const findings = study.findings as unknown as { order_tolerance: number; orders: OrderRow[]; failures: Failure[] };
  const engines = new Map<string, Engine>();
  const execution = new Map(timings.cases.flatMap((one) => one.engines.map((made) => [made.engine, made.execution] as const)));
  const engine_of = (label: string, engine: string, method: string): Engine => {
    const known = engines.get(label);
    if (known) return known;
    const made = { label, engine, method, exact: false, execution: execution.get(label) ?? "not stated", ...look_of(label) };
    engines.set(label, made);
    return made;
  };
  const all = new Map<string, { values: Values; mark: SpeedMark }>();
  const without_truth = new Set<string>();
  for (const { key, values: raw } of study.results) {
    const values = raw as unknown as Values;
    if (values.status === "no truth") without_truth.add(`${values.scenario} (${values.variant})`);
    const time = study.timings.results[key] as unknown as Time | undefined;
    if (typeof values.error !== "number" || !time?.median) continue;
    const mark: SpeedMark = {
      key,
      engine: engine_of(label_of(values), values.engine, values.method),
      setting: values.option ? `${values.option}=${values.setting}` : "",
      dt: values.dt,
      time: time.median,
      low: time.low,
      high: time.high,
      wide: time.wide,
      error: values.error,
      on_front: false,
    };
    all.set(key, { values, mark });
  }
  const marks_at = (keys: string[]): SpeedMark[] => keys.flatMap((key) => all.get(key)?.mark ?? []);
  const cases = timings.cases.map(({ scenario, variant, scale, front, engines: curves }): SpeedCase => {
    const here = [...all.values()].filter(({ values }) => values.scenario === scenario && values.variant === variant);
    const first = here[0]?.values;
    const made = curves.map(({ engine, front: own, ...readings }): SpeedCurve => {
      const marks = marks_at(own);
      for (const mark of marks) mark.on_front = true;
      return { ...readings, engine: engine_of(engine, engine, ""), front: marks };
    });
    return {
      scenario,
      variant,
      truth: first?.truth ?? "",
      truth_error: first?.truth_error ?? 0,
      scale,
      phases: first?.phases ?? 1,
      timed: first?.timed ?? 0,
      marks: here.map(({ mark }) => mark),
      curves: made,
      front: marks_at(front),
    };
  });
  return {
    order_tolerance: findings.order_tolerance,
    error_targets: timings.error_targets,
    scale_targets: timings.scale_targets,
    time_targets: timings.time_targets,
    cases,
    orders: findings.orders,
    without_truth: [...without_truth],
    failures: findings.failures,
  };
}

/** "1 cm", "1 mm", "0.1 mm" */
export const target_name = (error: number): string => (error >= 0.01 ? number(error * 100, "cm", 1) : number(error * 1000, "mm", 1));

/** The index of 1 mm among the error targets; that of a coarser one if nothing gets there. */
export function headline_target(cases: SpeedCase[]): number {
  const reached = (target: number): boolean => cases.some(({ curves }) => curves.some(({ time_for_error }) => time_for_error[target]));
  return [1, 0].find(reached) ?? 0;
}

/** Who gets to an error target in a case, the fastest first. */
export function ranking({ curves }: SpeedCase, target: number): { engine: Engine; time: number }[] {
  return curves
    .flatMap(({ engine, time_for_error }) => (time_for_error[target] ? [{ engine, time: time_for_error[target].value }] : []))
    .sort((a, b) => a.time - b.time);
}

/** Methods beside the engines themselves make charts crowded: at first only the fastest to some target are shown. */
export function few_of(cases: SpeedCase[]): Set<string> {
  const engines = cases.flatMap(({ curves }) => curves.map(({ engine }) => engine));
  const fastest = cases.flatMap((item) => [0, 1, 2].flatMap((target) => ranking(item, target).slice(0, 1)));
  return new Set([...engines.filter(({ label }) => !label.includes(":")), ...fastest.map(({ engine }) => engine)].map(({ label }) => label));
}

export interface Factor {
  engine: Engine;
  median: number | null; // over the cases it reaches, like the quartiles
  low: number | null;
  high: number | null;
  cases: number;
  reached: number; // in which it gets as accurate
  fastest: number;
}

/** With linear interpolation, as in reports/statistics.cpp. */
function quantile(sorted: number[], share: number): number | null {
  const position = share * (sorted.length - 1);
  const below = sorted[Math.floor(position)];
  const above = sorted[Math.ceil(position)];
  return below === undefined || above === undefined ? null : below + (position % 1) * (above - below);
}

/** The time of each engine / that of the fastest, to an error target, over cases: those it does not run or reach count, too. */
export function factors_over(cases: SpeedCase[], target: number): Factor[] {
  const found = new Map<Engine, number[]>();
  const fastest = new Map<Engine, number>();
  for (const item of cases) {
    for (const { engine } of item.curves) found.set(engine, found.get(engine) ?? []);
    const [best, ...rest] = ranking(item, target);
    if (!best) continue;
    fastest.set(best.engine, 1 + (fastest.get(best.engine) ?? 0));
    for (const { engine, time } of [best, ...rest]) found.get(engine)?.push(time / best.time);
  }
  return [...found].map(([engine, factors]) => {
    const sorted = [...factors].sort((a, b) => a - b);
    const at = (share: number): number | null => quantile(sorted, share);
    return { engine, median: at(0.5), low: at(0.25), high: at(0.75), cases: cases.length, reached: sorted.length, fastest: fastest.get(engine) ?? 0 };
  });
}
