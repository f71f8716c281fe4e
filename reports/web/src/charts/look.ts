// The look of engines in charts and legends, and the axes that charts share.
import * as Plot from "@observablehq/plot";
import { current_view, type View } from "../address";
import { choose_all, shows_engine, toggle, type Few } from "../chosen";
import { h } from "../dom";
import { number } from "../format";
import { mark_of, type Engine } from "../model";

/** The truth is a broad pale band below the lines of the engines. */
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

/** Charts grow with the page's font; their sizes are given for a font of 16 px. */
export const scale = (): number => parseFloat(getComputedStyle(document.documentElement).fontSize) / 16;

/** The size, margins and font of all charts. */
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

/** The look of the tip at the pointer. */
export const tip_look = { fill: "var(--paper)", stroke: "var(--faint)", lineHeight: 1.4 };

const marks = new Map<string, Element>();

/** Line and shape of an engine, drawn once and copied: a long page has hundreds. */
export function legend_mark(engine: Engine): Element {
  const known = marks.get(engine.label) ?? draw_mark(engine);
  marks.set(engine.label, known);
  return known.cloneNode(true) as Element;
}

/** The shape alone, around the origin, as path data. */
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

/** Allows a line break after each comma. */
function name_of({ label }: Engine): HTMLElement {
  const parts = label.split(/(?<=,)/).flatMap((part) => [h("wbr"), part]);
  return h("span", {}, ...parts);
}

/** How its code runs, if that is not native. */
function execution_of(engine: Engine): HTMLElement | null {
  const mark = mark_of(engine);
  return mark ? h("small", { class: "execution" }, mark) : null;
}

const chooser = new WeakMap<Element, { engine: Engine; few: Few }>();

/** Shows which engines are chosen, in all legends. */
export function update_legends(view: View): void {
  for (const button of document.querySelectorAll(".legend button")) {
    const of = chooser.get(button);
    if (of) button.setAttribute("aria-pressed", String(shows_engine(view, of.engine, of.few)));
  }
}

function entry(engine: Engine, few: Few): HTMLElement {
  if (engine.exact) return h("li", {}, legend_mark(engine), name_of(engine));
  const pressed = String(shows_engine(current_view(), engine, few));
  const button = h("button", { type: "button", title: "Show it alone in all charts; then others beside it", "aria-pressed": pressed }, legend_mark(engine), name_of(engine), execution_of(engine));
  chooser.set(button, { engine, few });
  button.addEventListener("click", () => toggle(engine.label));
  return h("li", {}, button);
}

/** Line, shape and name of each engine. A click isolates its curves in all charts. */
export function legend(engines: Engine[], few?: Few): HTMLElement {
  const all = h("button", { type: "button", class: "quiet" }, "All");
  all.addEventListener("click", choose_all);
  const several = engines.filter(({ exact }) => !exact).length > 1;
  return h("ul", { class: "legend" }, ...engines.map((engine) => entry(engine, few)), several ? h("li", {}, all) : null);
}

/** A logarithmic axis: a domain of at least a decade around the values, and round numbers as ticks. */
export function decades(values: number[], margin = 1.5): { domain: [number, number]; ticks: number[] } {
  const low = Math.min(...values) / margin;
  const high = Math.max(...values) * margin;
  const padding = Math.max(1, Math.sqrt(10 / (high / low)));
  const domain: [number, number] = [low / padding, high * padding];
  const [first, last] = [Math.floor(Math.log10(domain[0])), Math.ceil(Math.log10(domain[1]))];
  const steps = last - first > 3 ? [1] : [1, 2, 5];
  const powers = Array.from({ length: last - first + 1 }, (_, index) => first + index).filter((power) => (last - first < 9 || power % 2 === 0));
  const ticks = powers.flatMap((power) => steps.map((step) => step * 10 ** power));
  return { domain, ticks: ticks.filter((tick) => tick >= domain[0] && tick <= domain[1]) };
}

/** Smaller errors are round-off. */
const least_floor = 1e-12; // m

export interface ErrorAxes {
  x: object;
  y: object;
  floor: number; // m; smaller errors are drawn at the floor
}

/** Logarithmic axes for errors (m) against times (us), which also show the errors in `lines`. */
export function error_axes(errors: number[], times: number[], time_label: string, lines: number[] = []): ErrorAxes {
  const positive = errors.filter((error) => error > least_floor);
  const floor = positive.length ? 10 ** Math.floor(Math.log10(Math.min(...positive))) : least_floor;
  const below = errors.some((error) => error < floor);
  const short = (value: number) => number(value, "", 1);
  return {
    x: { type: "log", label: time_label, labelAnchor: "right", grid: true, ...decades(times), tickFormat: short },
    y: {
      type: "log",
      label: "distance from the truth, RMS (m)",
      grid: true,
      ...decades([floor, ...positive, ...lines.filter((line) => line > floor)]),
      tickFormat: (value: number) => (value === floor && below ? `\u2264 ${short(value)}` : short(value)),
    },
    floor,
  };
}

const letter_width = 6.6; // px, approximately
const font_size = 12.3; // px
const tick_space = 24; // px, beside the names

/** The y axis of a chart whose rows have names: up to half of the chart's width; longer names lose their middle. */
export function name_axis(width: number, names: string[]): { marginLeft: number; axis: Plot.Markish } {
  const longest = Math.max(0, ...names.map((name) => name.length));
  const marginLeft = Math.min(width / 2, (tick_space + longest * letter_width) * scale());
  const lineWidth = (marginLeft / scale() - tick_space / 2) / font_size;
  return { marginLeft, axis: Plot.axisY({ label: null, lineWidth, textOverflow: "ellipsis-middle" }) };
}
