// One quantity over time: a line for each engine, with a few marks of its shape.
import * as Plot from "@observablehq/plot";
import { chosen } from "../chosen";
import { given, number, pretty_unit } from "../format";
import type { Engine, Entry } from "../model";
import { playhead, type Cursor } from "./cursor";
import { decades, dot_look, line_look, plot_look, scale, tip_look } from "./look";

export interface Point {
  t: number;
  value: number;
  engine: Engine;
}

export interface OverTime {
  quantity: string;
  unit: string;
  entries: Entry[];
  column: "energy" | "momentum_x" | "momentum_y" | "angular_momentum" | "fastest" | "pose_difference" | "overlap";
  log?: boolean;
  floor?: number; // of a logarithmic axis: smaller values are drawn there; without one, values of 0 are not drawn
  limit?: { value: number; name: string }; // a horizontal line
  horizon: number | undefined; // s
  cursor: Cursor; // shared with the case's replay and its other charts
}

const height = 220; // px
const shapes_per_line = 5;
/** More points than pixels only cost time. */
const most_points = 1500;

function points_of(entry: Entry, { column, log = false, floor = 0 }: OverTime): Point[] {
  const { series, engine } = entry;
  if (!series) return [];
  const stride = Math.max(1, Math.ceil(series.t.length / most_points));
  const points: Point[] = [];
  series.t.forEach((t, index) => {
    const value = series[column][index];
    const wanted = index % stride === 0 || index === series.t.length - 1;
    if (!wanted || typeof value !== "number") return;
    const drawn = log ? Math.max(value, floor) : value;
    if (!log || drawn > 0) points.push({ t, value: drawn, engine });
  });
  return points;
}

interface Moment {
  t: number;
  points: Point[];
}

/** The points of all lines at one time. */
function moments_of(points: Point[]): Moment[] {
  const moments = new Map<number, Point[]>();
  for (const point of points) moments.set(point.t, [...(moments.get(point.t) ?? []), point]);
  return [...moments].map(([t, at]) => ({ t, points: at }));
}

const tip_text = ({ t, points }: Moment, unit: string): string =>
  [`at ${given(t, "s", 4)}`, ...points.map(({ engine, value }) => `${engine.label}: ${number(value, unit, 4)}`)].join("\n");

/** The marks of different lines are at different times, so that lines on top of each other can be told apart. */
function shapes(points: Point[], index: number, lines: number): Point[] {
  return Array.from({ length: shapes_per_line }, (_, k) => {
    const position = (k + (index + 0.5) / lines) / shapes_per_line;
    return points[Math.floor(position * points.length)];
  }).filter((point): point is Point => point !== undefined);
}

/** Covers at least 2 % of the values' size, so that round-off does not fill the chart. */
function linear_domain(points: Point[]): [number, number] {
  const values = points.map((point) => point.value);
  const low = Math.min(...values);
  const high = Math.max(...values);
  const least = 0.02 * Math.max(Math.abs(low), Math.abs(high)) || 1;
  const padding = Math.max(0, least - (high - low)) / 2;
  return [low - padding, high + padding];
}

export function over_time(width: number, chart_of: OverTime): Element {
  const { quantity, unit, entries, column, floor, limit, horizon, cursor } = chart_of;
  const found = chosen(entries);
  // Without a value above 0 there is nothing to show on a logarithmic axis.
  const log = (chart_of.log ?? false) && found.some((entry) => points_of(entry, chart_of).length > 0);
  const lines = found
    .filter((entry) => column !== "pose_difference" || !entry.engine.exact)
    .map((entry) => ({ engine: entry.engine, points: points_of(entry, { ...chart_of, log }) }))
    .filter((line) => line.points.length > 0);
  const all = lines.flatMap((line) => line.points);
  const moments = moments_of(all);
  const engines = lines.filter((line) => !line.engine.exact);
  const drawn = [...lines].sort((a, b) => Number(b.engine.exact) - Number(a.engine.exact));
  const chart = Plot.plot({
    ...plot_look(width, height),
    ariaLabel: `${quantity} over time`,
    x: { label: "time (s)", domain: [0, Math.max(...all.map(({ t }) => t))], labelAnchor: "right", ticks: Math.max(3, Math.floor(width / (90 * scale()))) },
    y: {
      label: `${quantity} (${pretty_unit(unit)})`,
      type: log ? "log" : "linear",
      grid: true,
      ...(log ? decades([...all.map(({ value }) => value), ...(limit ? [limit.value] : [])], 1) : { domain: linear_domain(all), nice: true, ticks: 5 }),
      tickFormat: log ? (value: number) => (value === floor ? `\u2264 ${number(value, "", 1)}` : number(value, "", 1)) : (value: number) => given(value),
    },
    marks: [
      ...(horizon === undefined
        ? []
        : [
            Plot.ruleX([horizon], { stroke: "var(--faint)", strokeDasharray: "4 3" }),
            Plot.text([horizon], { x: (t: number) => t, text: () => "horizon", frameAnchor: "top", textAnchor: "start", dx: 4, fill: "var(--faint)" }),
          ]),
      ...(limit === undefined ? [] : [Plot.ruleY([limit.value], { stroke: "var(--faint)", strokeDasharray: "4 3" })]),
      ...drawn.map(({ engine, points }) =>
        Plot.line(points, { x: "t", y: "value", ...line_look(engine), className: "line", ariaDescription: engine.label }),
      ),
      // Above the lines, so that it can be read.
      ...(limit === undefined
        ? []
        : [
            Plot.text([limit.value], { y: (value: number) => value, text: () => limit.name, frameAnchor: "left", textAnchor: "start", dx: 8, dy: 9, fill: "var(--soft)", stroke: "var(--card)", strokeWidth: 4 }),
          ]),
      ...engines.map(({ engine, points }, index) =>
        Plot.dot(shapes(points, index, engines.length), { x: "t", y: "value", r: 3.5, ...dot_look(engine), ariaHidden: "true" }),
      ),
      Plot.ruleX(moments, Plot.pointerX({ x: "t", stroke: "var(--faint)" })),
      Plot.tip(moments, Plot.pointerX({ x: "t", frameAnchor: "top-left", title: (moment: Moment) => tip_text(moment, unit), ...tip_look })),
    ],
  });
  playhead(chart, cursor);
  return chart;
}
