// How a engine looks in every chart and legend.
// The axes of every chart of error against time, both logarithmic.
// The axis of a chart whose rows have names: as wide as the longest needs, and no wider than half of the chart, for which
// longer ones lose their middle.
import * as Plot from "@observablehq/plot";
import { h } from "../dom";
import { number } from "../format";
import type { Engine } from "../model";

/** The truth is a broad pale band that engines are drawn upon. */
export const line_look = (engine: Engine) =>
  engine.exact
    ? { stroke: engine.color, strokeWidth: 7, strokeLinecap: "round" as const }
    : { stroke: engine.color, strokeWidth: 1.75, strokeDasharray: engine.dash };

export const dot_look = (engine: Engine) => ({
  symbol: engine.symbol as Plot.SymbolType,
  fill: engine.color,
  stroke: "var(--paper)",
  strokeWidth: 1,
});

/** Charts grow with the page's type: sizes are given for type of 16 px. */
export const scale = (): number => parseFloat(getComputedStyle(document.documentElement).fontSize) / 16;

/** What all charts share. */
export function plot_look(width: number, height: number): Plot.PlotOptions {
  const size = scale();
  return {
    width,
    height: height * size,
    marginLeft: 56 * size,
    marginTop: 27 * size,
    marginRight: 12 * size,
    marginBottom: 38 * size,
    style: { fontFamily: "inherit", fontSize: "0.77rem", background: "none", overflow: "visible" },
  };
}

/** What the pointer is told. */
export const tip_look = { fill: "var(--paper)", stroke: "var(--faint)", lineHeight: 1.4 };

const marks = new Map<string, Element>();

/** Line and shape of a engine; drawn once, for a long page has hundreds. */
export function legend_mark(engine: Engine): Element {
  const known = marks.get(engine.label) ?? draw_mark(engine);
  marks.set(engine.label, known);
  return known.cloneNode(true) as Element;
}

/** Its shape alone, about the origin: the data of a path. */
export function shape_of(engine: Engine): string {
  const mark = legend_mark(engine);
  const radius = Number(mark.querySelector("circle")?.getAttribute("r") ?? 0);
  return mark.querySelector("path")?.getAttribute("d") ?? `M${radius},0A${radius},${radius},0,1,1,${-radius},0A${radius},${radius},0,1,1,${radius},0`;
}

function draw_mark(engine: Engine): Element {
  const drawn = Plot.plot({
    width: 36,
    height: 16,
    margin: 0,
    x: { domain: [0, 36], axis: null },
    y: { domain: [0, 16], axis: null },
    marks: [
      Plot.ruleY([8], { ...line_look(engine), x1: 4, x2: 32 }),
      engine.exact ? null : Plot.dot([[18, 8]], { ...dot_look(engine), r: 4 }),
    ],
  });
  drawn.setAttribute("aria-hidden", "true");
  return drawn;
}

/** A long name may go on in a new line after a comma. */
function name_of({ label }: Engine): HTMLElement {
  const parts = label.split(/(?<=,)/).flatMap((part) => [h("wbr"), part]);
  return h("span", {}, ...parts);
}

/** Line, shape and name of each engine. */
export function legend(engines: Engine[]): HTMLElement {
  return h("ul", { class: "legend" }, ...engines.map((engine) => h("li", {}, legend_mark(engine), name_of(engine))));
}

/** For a logarithmic axis: a domain of a decade at least, with room about the values, and round numbers to label in it. */
export function decades(values: number[], room = 1.5): { domain: [number, number]; ticks: number[] } {
  const low = Math.min(...values) / room;
  const high = Math.max(...values) * room;
  const lack = Math.max(1, Math.sqrt(10 / (high / low)));
  const domain: [number, number] = [low / lack, high * lack];
  const [first, last] = [Math.floor(Math.log10(domain[0])), Math.ceil(Math.log10(domain[1]))];
  const steps = last - first > 3 ? [1] : [1, 2, 5];
  const powers = Array.from({ length: last - first + 1 }, (_, index) => first + index).filter((power) => (last - first < 9 || power % 2 === 0));
  const ticks = powers.flatMap((power) => steps.map((step) => step * 10 ** power));
  return { domain, ticks: ticks.filter((tick) => tick >= domain[0] && tick <= domain[1]) };
}

/** Smaller errors are round-off; they stand at the foot of the chart. */
const least_floor = 1e-12; // m

export interface ErrorAxes {
  x: object;
  y: object;
  floor: number; // m: errors below it are drawn there
}

/** For these errors (m), of which `lines` (m) are ruled across, and times (us). */
export function error_axes(errors: number[], times: number[], time_label: string, lines: number[] = []): ErrorAxes {
  const positive = errors.filter((error) => error > least_floor);
  const floor = positive.length ? 10 ** Math.floor(Math.log10(Math.min(...positive))) : least_floor;
  const foot = errors.some((error) => error < floor);
  const short = (value: number) => number(value, "", 1);
  return {
    x: { type: "log", label: time_label, labelAnchor: "right", grid: true, ...decades(times), tickFormat: short },
    y: {
      type: "log",
      label: "distance from the truth, RMS (m)",
      grid: true,
      ...decades([floor, ...positive, ...lines.filter((line) => line > floor)]),
      tickFormat: (value: number) => (value === floor && foot ? `\u2264 ${short(value)}` : short(value)),
    },
    floor,
  };
}

const letter = 6.6; // px, about
const type = 12.3; // px
const ticks = 24; // px, beside the names

export function name_axis(width: number, names: string[]): { marginLeft: number; axis: Plot.Markish } {
  const longest = Math.max(0, ...names.map((name) => name.length));
  const marginLeft = Math.min(width / 2, (ticks + longest * letter) * scale());
  const lineWidth = (marginLeft / scale() - ticks / 2) / type;
  return { marginLeft, axis: Plot.axisY({ label: null, lineWidth, textOverflow: "ellipsis-middle" }) };
}
