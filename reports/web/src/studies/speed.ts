// Speed against accuracy: the time of each method at equal error, over all cases and in each, the runs with their command
// lines, and the orders of convergence.
import { legend } from "../charts/look";
import type { Study } from "../data";
import type { StudyView } from "../model";
import { h, slug, table } from "../dom";
import { folded } from "../folded";
import { count, enumerate, given, number, step_word, time_step } from "../format";
import { command, copy, copy_button, run_command } from "../pieces";
import { equal_error_chart, work_precision } from "./speed_charts";
import { factors_over, speed_model, type OrderRow, type Reading, type SpeedCase, type SpeedMark, type SpeedModel } from "./speed_model";

function line_of(item: SpeedCase, { engine, setting, dt }: SpeedMark): string {
  const { scenario, variant, truth } = item;
  return run_command({ scenario, variant, engine: engine.label, setting, dt: step_word(dt), converged: truth === "converged" });
}

/** The command of the clicked point, and the callback that shows and copies it. */
function chosen_run(item: SpeedCase): { element: HTMLElement; choose: (mark: SpeedMark) => void } {
  const element = h("div", { class: "chosen" }, h("p", { class: "basis" }, "Click a point to copy its command line."));
  const choose = (mark: SpeedMark): void => {
    const line = line_of(item, mark);
    const status = h("p", { class: "basis", role: "status" }, `${mark.engine.label}, step ${time_step(mark.dt)}`);
    element.replaceChildren(status, command(line));
    void copy(line).then((copied) => copied && status.append(": copied"));
  };
  return { element, choose };
}

/** For print: lines break between words only, because a line that ends with "--" would be misread. */
function on_paper(line: string): HTMLElement {
  return h("code", { class: "on-paper" }, ...line.split(" ").flatMap((word) => [h("span", {}, word), " "]));
}

function row(item: SpeedCase, mark: SpeedMark): HTMLTableRowElement {
  const line = line_of(item, mark);
  const cells: [string, string | Node][] = [
    ["setting", mark.setting || "\u2013"],
    ["step", time_step(mark.dt)],
    ["error", number(mark.error, "m", 2)],
    ["time per simulated second", number(mark.time * 1e6, "\u00b5s")],
    ["command line", h("span", {}, on_paper(line), copy_button(line))],
  ];
  return h("tr", {}, h("th", { scope: "row" }, mark.engine.label), ...cells.map(([head, cell]) => h("td", { "data-label": head }, cell)));
}

function all_runs(item: SpeedCase): HTMLElement {
  return folded(`All ${item.marks.length} runs and their command lines`, () => {
    const marks = [...item.marks].sort((a, b) => a.engine.label.localeCompare(b.engine.label) || a.time - b.time);
    const heads = ["method", "setting", "step", "distance from the truth, RMS", "time per simulated second", "command line"];
    return [table("Runs of this case", heads, marks.map((mark) => row(item, mark)), "numbers")];
  });
}

const duration = (value: number): string => (value < 1e-3 ? number(value * 1e6, "\u00b5s") : value < 1 ? number(value * 1e3, "ms") : number(value, "s"));

function reading(found: Reading | null, unit: (value: number) => string, best: boolean, head: string): HTMLElement {
  if (!found) return h("td", { class: "none", "data-label": head }, "not reached");
  const text = (found.bound ? "\u2264 " : "") + unit(found.value);
  return h("td", { "data-label": head }, best ? h("strong", {}, text) : text);
}

interface Column {
  head: string;
  readings: (Reading | null)[];
}

/** Leaves out columns that no method reaches. */
function readings(caption: string, item: SpeedCase, columns: Column[], unit: (value: number) => string): HTMLElement | null {
  const shown = columns.filter((column) => column.readings.some((one) => one !== null));
  if (!shown.length) return null;
  const least = shown.map((column) => Math.min(...column.readings.map((one) => one?.value ?? Infinity)));
  const rows = item.curves.map(({ engine }, row) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, engine.label),
      ...shown.map((column, index) => {
        const found = column.readings[row] ?? null;
        return reading(found, unit, found?.value === least[index], column.head);
      }),
    ),
  );
  return table(caption, ["", ...shown.map(({ head }) => head)], rows, "numbers");
}

function case_section(model: SpeedModel, item: SpeedCase): HTMLElement {
  const times = model.error_targets.map((target, index) => ({
    head: `to ${number(target, "m", 1)}`,
    readings: item.curves.map(({ time_for_error }) => time_for_error[index] ?? null),
  }));
  const errors = model.time_targets.map((target, index) => ({
    head: `in ${duration(target)}`,
    readings: item.curves.map(({ error_for_time }) => error_for_time[index] ?? null),
  }));
  const truth = item.truth === "converged" ? `a converged reference with an error of ${number(item.truth_error, "m", 2)}` : `the closed form \u201c${item.truth}\u201d`;
  const chosen = chosen_run(item);
  return h(
    "article",
    { id: slug(item.scenario, item.variant), class: "case" },
    h("h3", {}, item.variant ? `${item.scenario}, ${item.variant}` : item.scenario),
    h("p", {}, `Compared with ${truth}${item.phases > 1 ? `; each error is the RMS over ${item.phases} phases, because impacts fall anywhere in a step` : ""}. Timed: the first ${given(item.timed, "s", 3)}.`),
    legend(item.curves.map(({ engine }) => engine)),
    work_precision(item, chosen.choose),
    chosen.element,
    folded("Time for a given error, and error for a given time", () => [
      readings("Time per simulated second, to be this close to the truth", item, times, duration),
      readings("Distance from the truth, RMS, with this time per simulated second", item, errors, (value) => number(value, "m", 2)),
    ]),
    all_runs(item),
  );
}

const interval = ({ order, half_width }: OrderRow): string =>
  order === null ? "\u2013" : `${order.toFixed(2)} \u00b1 ${(half_width ?? 0).toFixed(2)}`;

function order_table(caption: string, rows: OrderRow[]): HTMLElement {
  return table(
    caption,
    ["case", "method", "stated", "measured", "steps", "finding"],
    rows.map((row) =>
      h(
        "tr",
        { "data-finding": row.finding },
        h("th", { scope: "row" }, `${row.scenario}, ${row.variant}`),
        h("td", { "data-label": "method" }, row.engine + (row.option && !row.standard ? `, ${row.option}=${row.setting}` : "")),
        h("td", { "data-label": "stated" }, row.stated === null ? "\u2013" : String(row.stated)),
        h("td", { "data-label": "measured" }, interval(row)),
        h("td", { "data-label": "steps" }, String(row.points)),
        h("td", { "data-label": "finding" }, row.finding === "exact" ? "exact to round-off" : row.finding),
      ),
    ),
    "numbers",
  );
}

function orders(model: SpeedModel): HTMLElement {
  const known = model.orders.filter(({ stated, standard }) => stated !== null && standard);
  const rest = model.orders.filter((row) => !known.includes(row) && row.order !== null);
  return h(
    "section",
    { id: "orders" },
    h("h2", {}, "Orders of convergence"),
    h(
      "p",
      { class: "lede" },
      `The slope of log error over log step, with the 95 % interval of the fit. Methods state their order for smooth motion; \u201cas stated\u201d means within ${model.order_tolerance}.`,
    ),
    known.length ? order_table("Stated orders", known) : null,
    rest.length ? folded("Without a stated order, and at other settings", () => [order_table("Measured orders", rest)]) : null,
  );
}

function overall(model: SpeedModel): HTMLElement {
  return h(
    "section",
    { id: "overall" },
    h("h2", {}, "At equal error"),
    h(
      "p",
      { class: "lede" },
      `The time of each method / that of ${model.standard}, at the errors of ${model.standard}. Values are interpolated along the front and never extrapolated; a case counts only if the method gets as accurate.`,
    ),
    equal_error_chart(model.standard, factors_over(model.cases), "all cases"),
  );
}

function sentence(model: SpeedModel): string {
  const ranked = factors_over(model.cases).filter(({ median, engine }) => median !== null && engine.label !== model.standard);
  const best = [...ranked].sort((a, b) => b.reached - a.reached || (a.median ?? 0) - (b.median ?? 0))[0];
  const steps = [...new Set(model.cases.flatMap(({ marks }) => marks.map(({ dt }) => dt)))];
  const range = steps.length ? `, steps from ${time_step(Math.max(...steps))} to ${time_step(Math.min(...steps))}` : "";
  if (!best || best.median === null) return `${count(model.cases.length, "case")} measured${range}.`;
  const factor = best.median <= 1 ? `${number(1 / best.median, "", 2)} times as fast as` : `${number(best.median, "", 2)} times as slow as`;
  return `At equal error ${best.engine.label} is ${factor} ${model.standard} (median of the ${best.reached} of ${best.cases} cases where it gets as accurate)${range}.`;
}

export function speed(study: Study): StudyView {
  const model = speed_model(study);
  const scenarios = [...new Set(model.cases.map(({ scenario }) => scenario))];
  const absent = model.without_truth.length
    ? h("p", { class: "absence" }, `No truth for ${enumerate(model.without_truth)}.`)
    : null;
  return {
    sentence: sentence(model),
    sections: [
      { id: "overall", name: "At equal error", content: () => overall(model) },
      { id: "orders", name: "Orders", content: () => orders(model) },
      ...scenarios.map((name) => ({
        id: slug(name),
        name,
        content: () => h(
          "section",
          { id: slug(name), class: "chapter" },
          h("h2", {}, name),
          ...model.cases.filter(({ scenario }) => scenario === name).map((item) => case_section(model, item)),
        ),
      })),
      ...(absent ? [{ id: "absent", name: "Without truth", content: () => h("section", { id: "absent" }, h("h2", {}, "Without a truth"), absent) }] : []),
    ],
  };
}
