// What each feature is worth in one case: how much worse and how much cheaper the model is without it.
import * as Plot from "@observablehq/plot";
import { number } from "../format";
import type { Drop, ModelCase } from "../studies/least_model";
import { decades } from "./decades";
import { figure } from "./figure";
import { plot_look, tip_look } from "./look";
import { name_axis } from "./name_axis";

const row_height = 20;
const least_change = 1e-9; // m; smaller ones are drawn there

const label = ({ setting }: Drop): string => setting.replaceAll(/(integrator|solver)=/g, "").replaceAll(",", ", ");
const colour = ({ within }: Drop): string => (within ? "var(--right)" : "var(--wrong)");
const change_of = ({ change }: Drop): number => Math.max(least_change, change ?? Infinity);

const described = (drop: Drop): string =>
  [
    `${drop.feature}: without ${drop.without}`,
    drop.setting,
    drop.change === null ? drop.why || "does not run to the end" : `worse by ${number(drop.change, "m", 2)}`,
    drop.ratio === null ? "" : `${number(drop.ratio, "", 2)} of the cost`,
  ]
    .filter(Boolean)
    .join("\n");

function panel(drops: Drop[], width: number, about: string, x: object, marks: Plot.Markish[]): Element {
  const { marginLeft, axis } = name_axis(width, drops.map(label));
  return Plot.plot({
    ...plot_look(width, 60 + row_height * drops.length),
    marginLeft,
    ariaLabel: about,
    x: { grid: true, labelAnchor: "right", ...x },
    y: { domain: drops.map(label) },
    marks: [axis, ...marks],
  });
}

function cost_panel(drops: Drop[], width: number): Element {
  const timed = drops.filter(({ ratio }) => ratio !== null);
  const most = Math.min(2, Math.max(1.1, ...timed.map(({ ratio }) => ratio ?? 0)));
  const end = ({ ratio }: Drop) => Math.min(ratio ?? 0, most);
  return panel(drops, width, "Cost without each feature, the full model = 1", { label: "cost, full model = 1", domain: [0, most] }, [
    Plot.barX(timed, { x1: 0, x2: end, y: label, fill: colour, fillOpacity: 0.75, insetTop: 3, insetBottom: 3, className: "cost" }),
    Plot.ruleX([1], { stroke: "var(--ink)", strokeDasharray: "2 3" }),
    Plot.tip(timed, Plot.pointerY({ x: end, y: label, title: described, ...tip_look })),
  ]);
}

function error_panel(drops: Drop[], width: number, tolerance: number): Element {
  const ran = drops.filter(({ change }) => change !== null);
  const { domain, ticks } = decades([least_change, tolerance, ...ran.map(change_of)]);
  const foot = (value: number) => (value <= least_change ? `\u2264 ${number(value, "", 1)}` : number(value, "", 1));
  return panel(drops, width, "Error added without each feature", { type: "log", domain, ticks, tickFormat: foot, label: "worse by (m)" }, [
    Plot.ruleX([tolerance], { stroke: "var(--ink)", strokeDasharray: "2 3" }),
    Plot.ruleY(ran, { x1: domain[0], x2: change_of, y: label, stroke: colour, strokeOpacity: 0.4 }),
    Plot.dot(ran, { x: change_of, y: label, r: 4.5, fill: colour, className: "change" }),
    Plot.tip(ran, Plot.pointerY({ x: change_of, y: label, title: described, ...tip_look })),
  ]);
}

export function ablation_chart({ drops }: ModelCase, tolerance: number): HTMLElement {
  return figure({
    title: "Without one feature",
    note: "What the model is worse by, and what it then costs. Green stays within the tolerance (dashed) and may go; red may not.",
    height: 120 + 2 * row_height * drops.length,
    draw: (width) => {
      const each = width > 900 ? Math.floor(width / 2) - 8 : width;
      return [error_panel(drops, each, tolerance), cost_panel(drops, each)];
    },
  });
}
