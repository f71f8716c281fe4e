// How a contender looks in every chart and legend.
import * as Plot from "@observablehq/plot";
import { h } from "../dom";
import type { Contender } from "../model";

/** The truth is a broad pale band that engines are drawn upon. */
export const line_look = (contender: Contender) =>
  contender.exact
    ? { stroke: contender.color, strokeWidth: 7, strokeLinecap: "round" as const }
    : { stroke: contender.color, strokeWidth: 1.75, strokeDasharray: contender.dash };

export const dot_look = (contender: Contender) => ({
  symbol: contender.symbol as Plot.SymbolType,
  fill: contender.color,
  stroke: "var(--paper)",
  strokeWidth: 1,
});

/** What all charts share. */
export const plot_look = (width: number, height: number): Plot.PlotOptions => ({
  width,
  height,
  style: { fontFamily: "inherit", fontSize: "12px", background: "none", overflow: "visible" },
});

const swatch = (contender: Contender): Element =>
  Plot.plot({
    ...plot_look(36, 16),
    margin: 0,
    x: { domain: [0, 36], axis: null },
    y: { domain: [0, 16], axis: null },
    marks: [
      Plot.ruleY([8], { ...line_look(contender), x1: 4, x2: 32 }),
      contender.exact ? null : Plot.dot([[18, 8]], { ...dot_look(contender), r: 4 }),
    ],
  });

/** Line, shape and name of each contender. */
export function legend(contenders: Contender[]): HTMLElement {
  return h("ul", { class: "legend" }, ...contenders.map((contender) => h("li", {}, swatch(contender), contender.label)));
}
