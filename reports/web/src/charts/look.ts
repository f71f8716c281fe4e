// How a engine looks in every chart and legend.
import * as Plot from "@observablehq/plot";
import { h } from "../dom";
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
