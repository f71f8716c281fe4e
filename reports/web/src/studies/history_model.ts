// The findings of the history, as its view uses them: snapshots in order, and what changed from one to the next.
import type { Study } from "../data";
import { words } from "../format";

export const step_time = "step_us";

export interface Snapshot {
  id: string;
  commit: string;
  at: string;
}

interface Subject {
  scenario: string;
  variant: string;
  engine: string;
  dt: number;
}

/** The means before and after a change, and its p value: 0 for a change of exact numbers. */
export interface ChangePoint {
  at: number; // index into the trend's values
  before: number;
  after: number;
  p: number;
}

/** Columns of equal length, with one entry for each snapshot that has the metric. */
export interface Trend extends Subject {
  metric: string;
  unit: string;
  machine: string; // that measured the times; "" for metrics that do not depend on the clock
  snapshots: number[];
  values: number[];
  low: number[];
  high: number[];
  changes: ChangePoint[];
}

export interface VerdictChange extends Subject {
  snapshot: number;
  before: string;
  after: string;
}

export interface HistoryModel {
  snapshots: Snapshot[];
  trends: Trend[];
  verdicts: VerdictChange[];
  unchanged: number; // series without a change, which are not among the trends
  level: number;
}

export function history_of(study: Study): HistoryModel {
  const findings = study.findings as { verdicts: VerdictChange[]; trends: Trend[]; unchanged: number };
  const times = study.timings.trends as unknown as Trend[];
  return {
    snapshots: study.results.map(({ key, values }) => ({ id: key, commit: String(values.commit), at: String(values.at) })),
    trends: [...findings.trends, ...times],
    verdicts: findings.verdicts,
    unchanged: findings.unchanged,
    level: Number(study.configuration.level),
  };
}

/** The first 8 characters, and a star if the tree had changes. */
export const short_commit = ({ commit }: Snapshot): string => commit.slice(0, 8) + (commit.endsWith("-dirty") ? "*" : "");
/** The metric's name on the page. */
export const metric_name = (metric: string): string => (metric === step_time ? "time per step" : words(metric));
export const day = ({ at }: Snapshot): string => at.slice(0, 10);

/** Trends of one metric in one case, which share a chart. */
export interface Panel {
  scenario: string;
  variant: string;
  metric: string;
  unit: string;
  dt: number;
  machine: string;
  trends: Trend[];
}

export function panels_of(trends: Trend[]): Panel[] {
  const panels = new Map<string, Panel>();
  for (const trend of trends) {
    const { scenario, variant, metric, unit, dt, machine } = trend;
    const key = JSON.stringify([scenario, variant, metric, unit, dt, machine]);
    const panel = panels.get(key) ?? { scenario, variant, metric, unit, dt, machine, trends: [] };
    panel.trends.push(trend);
    panels.set(key, panel);
  }
  return [...panels.values()];
}
