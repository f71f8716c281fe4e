// The history as its page thinks of it: snapshots in their order, and what changed from one to the next.
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

/** Means of what lies before and after; p: 0 of a change to the bit. */
export interface ChangePoint {
  at: number; // place in the trend's values
  before: number;
  after: number;
  p: number;
}

/** Columns of equal length: an entry for each snapshot that has the metric. */
export interface Trend extends Subject {
  metric: string;
  unit: string;
  machine: string; // that times were taken on; "" of what hangs on no clock
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
  unchanged: number; // series that are not among the trends
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

/** As much of a commit as tells it. */
export const short_commit = ({ commit }: Snapshot): string => commit.slice(0, 8) + (commit.endsWith("-dirty") ? "*" : "");
/** In words; of step times as the report has it. */
export const metric_name = (metric: string): string => (metric === step_time ? "time per step" : words(metric));
export const day = ({ at }: Snapshot): string => at.slice(0, 10);

/** Trends of one metric in one case, which a chart shows together. */
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
