// The chart of a metric over snapshots: a line for each engine, the middle half of repetitions for times, and a ring at
// each lasting change.
import * as Plot from "@observablehq/plot";
import { dot_look, line_look, plot_look, scale, tip_look } from "../charts/look";
import { given, number, pretty_unit } from "../format";
import type { Engine } from "../model";
import { day, metric_name, short_commit, type Panel, type Snapshot, type Trend } from "./history_model";

const height = 240; // px

interface Point {
  snapshot: number;
  value: number;
  low: number;
  high: number;
  engine: Engine;
}

interface Change extends Point {
  before: number;
  after: number;
  p: number;
}

const points_of = (trend: Trend, engine: Engine): Point[] =>
  trend.values.map((value, index) => ({
    snapshot: trend.snapshots[index] ?? 0,
    value,
    low: trend.low[index] ?? value,
    high: trend.high[index] ?? value,
    engine,
  }));

const changes_of = (trend: Trend, points: Point[]): Change[] =>
  trend.changes.flatMap(({ at, ...change }) => {
    const point = points[at];
    return point ? [{ ...point, ...change }] : [];
  });

/** "exact" for numbers that repeat to the bit, else the p value. */
export const certainty = (p: number): string => (p === 0 ? "exact" : `p ${number(p, "", 1)}`);

function tip_text(snapshot: Snapshot | undefined, { engine, value, low, high }: Point, unit: string, change: Change | undefined): string {
  return [
    snapshot ? `${day(snapshot)}  ${short_commit(snapshot)}` : "",
    `${engine.label}: ${number(value, unit, 4)}${high > low ? ` (${number(low, "", 3)} \u2013 ${number(high, "", 3)})` : ""}`,
    change ? `changes from ${number(change.before, unit, 4)} to ${number(change.after, unit, 4)}, ${certainty(change.p)}` : "",
  ]
    .filter(Boolean)
    .join("\n");
}

export function trend_chart(width: number, { metric, unit, trends }: Panel, snapshots: Snapshot[], engine_of: (label: string) => Engine): Element {
  const lines = trends.map((trend) => {
    const engine = engine_of(trend.engine);
    const points = points_of(trend, engine);
    return { engine, points, changes: changes_of(trend, points) };
  });
  const all = lines.flatMap(({ points }) => points);
  const changes = lines.flatMap((line) => line.changes);
  const last = Math.max(1, snapshots.length - 1);
  const labels = Math.max(2, Math.floor(width / (110 * scale())));
  const stride = Math.max(1, Math.ceil(snapshots.length / labels));
  const low = Math.min(...all.map((point) => point.low));
  const high = Math.max(...all.map((point) => point.high));
  const padding = high > low ? 0 : Math.abs(high) * 0.02 || 1;
  const change_at = new Map(changes.map((change) => [`${change.engine.label} ${change.snapshot}`, change]));
  return Plot.plot({
    ...plot_look(width, height),
    ariaLabel: `${metric_name(metric)} over snapshots`,
    x: {
      label: "snapshot",
      labelAnchor: "right",
      domain: [0, last],
      ticks: snapshots.map((_, index) => index).filter((index) => index % stride === 0),
      tickFormat: (index: number) => (snapshots[index] ? short_commit(snapshots[index]) : ""),
    },
    y: {
      label: `${metric_name(metric)}${unit && unit !== "1" ? ` (${pretty_unit(unit)})` : ""}`,
      grid: true,
      nice: true,
      ticks: 5,
      domain: [low - padding, high + padding],
      tickFormat: (value: number) => given(value, "", 4),
    },
    marks: [
      Plot.ruleX([...new Set(changes.map(({ snapshot }) => snapshot))], { stroke: "var(--faint)", strokeDasharray: "4 3" }),
      ...lines.map(({ engine, points }) =>
        Plot.areaY(points, { x: "snapshot", y1: "low", y2: "high", fill: engine.color, fillOpacity: 0.15, ariaHidden: "true" }),
      ),
      ...lines.map(({ engine, points }) =>
        Plot.line(points, { x: "snapshot", y: "value", ...line_look(engine), className: "line", ariaDescription: engine.label }),
      ),
      ...lines.map(({ engine, points }) => Plot.dot(points, { x: "snapshot", y: "value", r: 2.5, ...dot_look(engine), ariaHidden: "true" })),
      Plot.dot(changes, { x: "snapshot", y: "value", r: 7, stroke: "var(--wrong)", strokeWidth: 2, className: "change" }),
      Plot.tip(
        all,
        Plot.pointer({
          x: "snapshot",
          y: "value",
          title: (point: Point) =>
            tip_text(snapshots[point.snapshot], point, unit, change_at.get(`${point.engine.label} ${point.snapshot}`)),
          ...tip_look,
        }),
      ),
    ],
  });
}
