// The findings of the speed study, as its view uses them.
import type { Study } from "../data";
import { label_of, look, type Engine } from "../model";

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
  error_for_time: (Reading | null)[];
  factor: number | null; // its time / the standard's at equal error; null if it does not get as accurate
}

export interface SpeedCase {
  scenario: string;
  variant: string;
  truth: string;
  truth_error: number; // m
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
  standard: string;
  order_tolerance: number;
  error_targets: number[];
  time_targets: number[];
  cases: SpeedCase[];
  orders: OrderRow[];
  without_truth: string[];
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
  standard: string;
  error_targets: number[];
  time_targets: number[];
  cases: {
    scenario: string;
    variant: string;
    front: string[];
    engines: { engine: string; front: string[]; time_for_error: (Reading | null)[]; error_for_time: (Reading | null)[]; factor: number | null }[];
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
  const findings = study.findings as unknown as { order_tolerance: number; orders: OrderRow[] };
  const engines = new Map<string, Engine>();
  const engine_of = (label: string, engine: string, method: string): Engine => {
    const known = engines.get(label);
    if (known) return known;
    const made = { label, engine, method, exact: false, ...look(engines.size) };
    engines.set(label, made);
    return made;
  };
  // Default engines get the first looks, which differ the most.
  for (const { values } of study.results) {
    const { engine, method } = values as unknown as Values;
    if (engine && !method) engine_of(engine, engine, "");
  }
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
  const cases = timings.cases.map(({ scenario, variant, front, engines: curves }): SpeedCase => {
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
      phases: first?.phases ?? 1,
      timed: first?.timed ?? 0,
      marks: here.map(({ mark }) => mark),
      curves: made,
      front: marks_at(front),
    };
  });
  return {
    standard: timings.standard,
    order_tolerance: findings.order_tolerance,
    error_targets: timings.error_targets,
    time_targets: timings.time_targets,
    cases,
    orders: findings.orders,
    without_truth: [...without_truth],
  };
}

export interface Factor {
  engine: Engine;
  median: number | null; // over the cases it reaches, like the quartiles
  low: number | null;
  high: number | null;
  cases: number;
  reached: number; // in which it gets as accurate as the standard
}

/** With linear interpolation, as in reports/statistics.cpp. */
function quantile(sorted: number[], share: number): number | null {
  const position = share * (sorted.length - 1);
  const below = sorted[Math.floor(position)];
  const above = sorted[Math.ceil(position)];
  return below === undefined || above === undefined ? null : below + (position % 1) * (above - below);
}

/** The time of each engine / the standard's at equal error, over cases. */
export function factors_over(cases: SpeedCase[]): Factor[] {
  const found = new Map<Engine, (number | null)[]>();
  for (const { curves } of cases) {
    for (const { engine, factor } of curves) found.set(engine, [...(found.get(engine) ?? []), factor]);
  }
  return [...found].map(([engine, factors]) => {
    const sorted = factors.filter((factor) => factor !== null).sort((a, b) => a - b);
    const at = (share: number): number | null => quantile(sorted, share);
    return { engine, median: at(0.5), low: at(0.25), high: at(0.75), cases: factors.length, reached: sorted.length };
  });
}
