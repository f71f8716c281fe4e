// The heat map of one method in a map of the stability study: the outcome of every cell, the bisected boundary and the
// boundary by theory. Outcomes differ in colour (after Okabe and Ito, safe for colour-blind readers) and letter.
import * as Plot from "@observablehq/plot";
import { figure } from "../charts/figure";
import { plot_look, scale, tip_look } from "../charts/look";
import { h } from "../dom";
import { given, number } from "../format";
import type { Axis, Cell, MapRow, Outcome, Panel, StabilityMap } from "./stability_model";

interface Look {
  fill: string;
  ink: string; // of the letter on it
}

const dark = "#16181b";

const looks: Record<string, Look> = {
  h: { fill: "var(--right-wash)", ink: "var(--right)" },
  d: { fill: "#56b4e9", ink: dark },
  j: { fill: "#f0e442", ink: dark },
  s: { fill: "#009e73", ink: dark },
  t: { fill: "#cc79a7", ink: dark },
  o: { fill: "#e69f00", ink: dark },
  g: { fill: "#b3261e", ink: "#ffffff" },
  x: { fill: "var(--ink)", ink: "var(--paper)" },
  e: { fill: "var(--soft)", ink: "var(--paper)" },
};

const unknown: Look = { fill: "var(--quiet-wash)", ink: "var(--faint)" };

const outcome_look = ({ letter }: Outcome): Look => looks[letter] ?? unknown;

/** The letter in a cell; cells that hold have none. */
const outcome_letter = ({ letter }: Outcome): string => (letter === "h" ? "" : letter === "-" ? "\u2013" : letter);

export function outcome_legend(outcomes: Outcome[]): HTMLElement {
  const swatch = (outcome: Outcome) => {
    const { fill, ink } = outcome_look(outcome);
    return h("i", { class: "outcome", style: `background: ${fill}; color: ${ink}`, "aria-hidden": "true" }, outcome_letter(outcome));
  };
  return h("ul", { class: "legend outcomes" }, ...outcomes.map((outcome) => h("li", { title: outcome.about }, swatch(outcome), outcome.name)));
}

const height = 250;
const least_for_letters = 12; // px, of a cell

interface Rect {
  cell: Cell;
  row: MapRow;
  x1: number;
  x2: number;
  y1: number;
  y2: number;
}

/** The edges of cells: half-way between neighbours on the axis, and half a cell beyond both ends. */
function edges(values: number[], logarithmic: boolean): number[] {
  const on = values.map((value) => (logarithmic ? Math.log(value) : value));
  const between = on.slice(1).map((value, index) => (value + (on[index] ?? value)) / 2);
  const first = on[0] ?? 0;
  const last = on[on.length - 1] ?? 0;
  const all = on.length > 1 ? [2 * first - (between[0] ?? 0), ...between, 2 * last - (between[between.length - 1] ?? 0)] : [first - 0.5, first + 0.5];
  return logarithmic ? all.map(Math.exp) : all;
}

const label = ({ name, unit }: Axis): string => (unit ? `${name} (${unit})` : name);

/** Ticks of a logarithmic axis: 1, 2 or 5 times a power of ten, as many as fit. */
function ticks(axis: Axis, values: number[], most: number): number[] | undefined {
  if (!axis.logarithmic) return undefined;
  const low = Math.min(...values);
  const high = Math.max(...values);
  const all = (steps: number[]): number[] => {
    const found: number[] = [];
    for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); ++power) {
      for (const step of steps) found.push(Number(`${step}e${power}`));
    }
    return found.filter((value) => value >= low * 0.999 && value <= high * 1.001);
  };
  return [[1, 2, 5], [1, 3], [1]].map(all).find((found) => found.length <= most && found.length > 1) ?? all([1]);
}

function described(map: StabilityMap, panel: Panel, { cell, row }: Rect): string {
  const lines = [`${map.x.name} ${given(cell.x, map.x.unit, 3)}${panel.y ? `, ${panel.y.name} ${given(row.y, panel.y.unit, 3)}` : ""}`];
  lines.push(cell.since === null ? cell.outcome.name : `${cell.outcome.name} at ${number(cell.since, "s")}${cell.body ? `: ${cell.body}` : ""}`);
  row.brackets.forEach(({ low, high, outcome, theory }, index) => {
    const name = map.boundaries[index]?.name ?? "";
    if (low !== null && high !== null) lines.push(`${name}: ${given(low, "", 5)}, and at ${given(high, "", 5)} ${outcome}`);
    if (typeof theory === "number") lines.push(`${name} by theory: ${given(theory, "", 5)}`);
  });
  return lines.join("\n");
}

export function heat_map(map: StabilityMap, panel: Panel, note: string): HTMLElement {
  const { x } = map;
  const rows = [...panel.rows].sort((a, b) => a.y - b.y);
  const across = edges(x.values, x.logarithmic);
  const tall = panel.y ? edges(rows.map(({ y }) => y), panel.y.logarithmic) : [0, 1];
  const spans = rows.map((row, index) => ({ row, y1: tall[index] ?? 0, y2: tall[index + 1] ?? 1 }));
  const rects = spans.flatMap(({ row, y1, y2 }) =>
    row.cells.map((cell, index): Rect => ({ cell, row, x1: across[index] ?? 0, x2: across[index + 1] ?? 1, y1, y2 })),
  );
  const x_middle = (low: number, high: number): number => (x.logarithmic ? Math.sqrt(low * high) : (low + high) / 2);
  const inside = (value: number): boolean => value >= Math.min(...across) && value <= Math.max(...across);
  const measured = spans.flatMap(({ row, y1, y2 }) =>
    row.brackets.flatMap(({ low, high }) => (low !== null && high !== null ? { x1: low, x2: high, y1, y2 } : [])),
  );
  // One line through the brackets of rows above each other; null where a row has none.
  const steps = map.boundaries.flatMap((_, index) => [
    ...spans.flatMap(({ row, y1, y2 }) => {
      const { low = null, high = null } = row.brackets[index] ?? {};
      if (low === null || high === null) return [{ x: NaN, y: y1 }];
      const x = x_middle(low, high);
      return [{ x, y: y1 }, { x, y: y2 }];
    }),
    { x: NaN, y: 0 },
  ]);
  // Through the middles of the rows, extended to the edges of the map.
  const theory = map.boundaries.map((_, index) => {
    const at = spans.flatMap(({ row, y1, y2 }) => {
      const x = row.brackets[index]?.theory;
      return typeof x === "number" && inside(x) ? { x, y: panel.y ? row.y : (y1 + y2) / 2, y1, y2 } : [];
    });
    const [first] = at;
    const last = at[at.length - 1];
    return first && last ? [{ x: first.x, y: first.y1 }, ...at, { x: last.x, y: last.y2 }] : [];
  });
  const draw = (width: number) => {
    const size = scale();
    const look = plot_look(width, height);
    const [top = 1, bottom = 0] = [Math.max(...tall), Math.min(...tall)];
    const letters = (width - 70 * size) / x.values.length >= least_for_letters && ((height - 65) * size) / rows.length >= least_for_letters;
    return Plot.plot({
      ...look,
      marginLeft: (panel.y ? 50 : 12) * size,
      ariaLabel: `Outcome of each cell: ${panel.engine}`,
      x: {
        type: x.logarithmic ? "log" : "linear",
        domain: [across[0] ?? 0, across[across.length - 1] ?? 1],
        ticks: ticks(x, x.values, Math.max(3, Math.floor(width / (48 * size)))) ?? Math.max(3, Math.floor(width / (70 * size))),
        tickFormat: (value: number) => given(value, "", 3),
        label: label(x),
        labelAnchor: "right",
      },
      y: {
        type: panel.y?.logarithmic ? "log" : "linear",
        domain: [bottom, top],
        axis: panel.y ? "left" : null,
        ticks: panel.y ? (ticks(panel.y, rows.map(({ y }) => y), 7) ?? 5) : [],
        tickFormat: (value: number) => given(value, "", 3),
        label: panel.y ? label(panel.y) : null,
      },
      marks: [
        Plot.rect(rects, {
          x1: "x1",
          x2: "x2",
          y1: "y1",
          y2: "y2",
          fill: ({ cell }: Rect) => outcome_look(cell.outcome).fill,
          stroke: "var(--card)",
          strokeWidth: 0.5,
          className: "cells",
        }),
        letters
          ? Plot.text(rects, {
              x: ({ x1, x2 }: Rect) => (x.logarithmic ? Math.sqrt(x1 * x2) : (x1 + x2) / 2),
              y: ({ y1, y2 }: Rect) => (panel.y?.logarithmic ? Math.sqrt(y1 * y2) : (y1 + y2) / 2),
              text: ({ cell }: Rect) => outcome_letter(cell.outcome),
              fill: ({ cell }: Rect) => outcome_look(cell.outcome).ink,
              fontSize: 11 * size,
              className: "letters",
              ariaHidden: "true",
            })
          : null,
        Plot.line(steps, { x: "x", y: "y", stroke: "var(--ink)", strokeWidth: 2.5, strokeLinejoin: "round", className: "steps" }),
        Plot.rect(measured, { x1: "x1", x2: "x2", y1: "y1", y2: "y2", fill: "var(--ink)", stroke: "var(--ink)", strokeWidth: 2, className: "boundary" }),
        ...theory.flatMap((line) => [
          Plot.line(line, { x: "x", y: "y", stroke: "var(--card)", strokeWidth: 3.5, className: "halo" }),
          Plot.line(line, { x: "x", y: "y", stroke: "var(--ink)", strokeWidth: 1.75, strokeDasharray: "5 3", className: "theory" }),
        ]),
        Plot.tip(
          rects,
          Plot.pointer({
            x: ({ x1, x2 }: Rect) => (x.logarithmic ? Math.sqrt(x1 * x2) : (x1 + x2) / 2),
            y: ({ y1, y2 }: Rect) => (panel.y?.logarithmic ? Math.sqrt(y1 * y2) : (y1 + y2) / 2),
            title: (rect: Rect) => described(map, panel, rect),
            ...tip_look,
          }),
        ),
      ],
    });
  };
  return figure({ title: panel.engine, note, height, draw: (width) => [draw(width)] });
}
