// Speed against accuracy: the time of each method at equal error, over all cases and in each, the runs with their command
// lines, and the orders of convergence.
import { legend } from "../charts/look";
import type { Study } from "../data";
import { timed_label, unlike, type StudyView } from "../model";
import { h, slug, table } from "../dom";
import { folded } from "../folded";
import { count, enumerate, given, number, step_word, time_step } from "../format";
import { command, copy, copy_button, run_command } from "../pieces";
import { equal_error_chart, work_precision } from "./speed_charts";
import { factors_over, few_of, headline_target, ranking, speed_model, target_name, type Failure, type OrderRow, type Reading, type SpeedCase, type SpeedMark, type SpeedModel } from "./speed_model";

function line_of(item: SpeedCase, { engine, setting, dt }: SpeedMark): string {
  const { scenario, variant, truth } = item;
  return run_command({ scenario, variant, engine: engine.label, setting, dt: step_word(dt), converged: truth === "converged" });
}

/** The command of the clicked point, and the callback that shows and copies it. */
function chosen_run(item: SpeedCase): { element: HTMLElement; choose: (mark: SpeedMark) => void } {
  const element = h("div", { class: "chosen" }, h("p", { class: "basis" }, "Click a point to copy its command line."));
  const choose = (mark: SpeedMark): void => {
    const line = line_of(item, mark);
    const status = h("p", { class: "basis", role: "status" }, `${timed_label(mark.engine)}, step ${time_step(mark.dt)}`);
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
  return h("tr", {}, h("th", { scope: "row" }, timed_label(mark.engine)), ...cells.map(([head, cell]) => h("td", { "data-label": head }, cell)));
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
  if (!found) return h("td", { class: "none", "data-label": head }, "never");
  const text = (found.bound ? "\u2264 " : "") + unit(found.value);
  return h("td", { "data-label": head }, best ? h("strong", {}, text) : text);
}

interface Column {
  head: string;
  readings: (Reading | null)[];
}

/** Leaves out columns that no method reaches. The least value of a column is bold. */
function readings(caption: string, item: SpeedCase, columns: Column[], unit: (value: number) => string): HTMLElement | null {
  const shown = columns.filter((column) => column.readings.some((one) => one !== null));
  if (!shown.length) return null;
  const least = shown.map((column) => Math.min(...column.readings.map((one) => one?.value ?? Infinity)));
  const rows = item.curves.map(({ engine }, row) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, timed_label(engine)),
      ...shown.map((column, index) => {
        const found = column.readings[row] ?? null;
        return reading(found, unit, found?.value === least[index], column.head);
      }),
    ),
  );
  return table(caption, ["method", ...shown.map(({ head }) => head)], rows, "numbers");
}

/** "impulse is the fastest to 1 mm: 27 µs for a simulated second; next is soft-step, 45 times that. Never that accurate: box2d." */
function winner(item: SpeedCase, target: number, error: number): string {
  const [best, next] = ranking(item, target);
  if (!best) return `Nothing gets within ${target_name(error)}.`;
  const never = item.curves.filter(({ engine, time_for_error }) => !time_for_error[target] && !engine.label.includes(":")).map(({ engine }) => timed_label(engine));
  const kinds = next && next.engine.execution !== best.engine.execution ? ", but the two run differently: no factor of method alone" : "";
  const second = next ? `; next is ${timed_label(next.engine)}, ${number(next.time / best.time, "", 2)} times that${kinds}` : "";
  return `${timed_label(best.engine)} is the fastest to ${target_name(error)}: ${duration(best.time)} for a simulated second${second}.${never.length ? ` Never that accurate: ${enumerate(never)}.` : ""}`;
}

/** The time of each method to each error target, of one case. */
function target_columns(model: SpeedModel, item: SpeedCase): Column[] {
  const of_error = model.error_targets.map((target, index) => ({
    head: `to ${target_name(target)}`,
    readings: item.curves.map(({ time_for_error }) => time_for_error[index] ?? null),
  }));
  const of_scale = model.scale_targets.map((target, index) => ({
    head: `to ${given(100 * target, "%")}`,
    readings: item.curves.map(({ time_for_scale }) => time_for_scale[index] ?? null),
  }));
  return [...of_error, ...of_scale];
}

function case_section(model: SpeedModel, few: ReadonlySet<string>, item: SpeedCase): HTMLElement {
  const errors = model.time_targets.map((target, index) => ({
    head: `in ${duration(target)}`,
    readings: item.curves.map(({ error_for_time }) => error_for_time[index] ?? null),
  }));
  const truth = item.truth === "converged" ? `a converged reference with an error of ${number(item.truth_error, "m", 2)}` : `the closed form \u201c${item.truth}\u201d`;
  const run = chosen_run(item);
  const target = headline_target([item]);
  return h(
    "article",
    { id: slug(item.scenario, item.variant), class: "case" },
    h("h3", {}, item.variant ? `${item.scenario}, ${item.variant}` : item.scenario),
    model.cases.length > 1 ? h("p", {}, h("strong", {}, winner(item, target, model.error_targets[target] ?? 0))) : null,
    h("p", { class: "basis" }, `Compared with ${truth}${item.phases > 1 ? `; each error is the RMS over ${item.phases} phases, because impacts fall anywhere in a step` : ""}. 100 % of scale is ${number(item.scale, "m", 2)}, how far the bodies move. Timed: the first ${given(item.timed, "s", 3)}.`),
    legend(item.curves.map(({ engine }) => engine), few),
    work_precision(item, few, model.error_targets, run.choose),
    run.element,
    readings("Time for a simulated second, to be this close to the truth", item, target_columns(model, item), duration),
    folded("Error for a given time", () => [
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

const rule = "Times are read off the best runs of each method, by a power law between two of them, and never beyond them: the errors are the same for all methods and no method\u2019s own. \u2264: its cheapest run is already closer.";

function overall(model: SpeedModel): HTMLElement {
  const target = headline_target(model.cases);
  const name = target_name(model.error_targets[target] ?? 0);
  const every = model.error_targets.map((error, index) => ({ head: `to ${target_name(error)}`, factors: factors_over(model.cases, index) }));
  const rows = (every[0]?.factors ?? []).map(({ engine }, row) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, timed_label(engine)),
      ...every.map(({ head, factors }) => {
        const { median, reached = 0, fastest = 0 } = factors[row] ?? {};
        const text = typeof median === "number" ? `${number(median, "", 2)}\u00d7 in ${reached}${fastest ? `, fastest in ${fastest}` : ""}` : "never";
        return h("td", { "data-label": head, ...(typeof median === "number" ? {} : { class: "none" }) }, text);
      }),
    ),
  );
  return h(
    "section",
    { id: "overall" },
    h("h2", {}, `To ${name}`),
    h("p", { class: "lede" }, rule, " ", unlike(model.cases.flatMap(({ curves }) => curves.map(({ engine }) => engine)))),
    equal_error_chart(name, factors_over(model.cases, target), "all cases"),
    table(`Time / that of the fastest: the median over the cases, of ${model.cases.length}, in which a method gets there`, ["method", ...every.map(({ head }) => head)], rows, "numbers"),
  );
}

function sentence(model: SpeedModel): string {
  const [first, ...rest] = model.cases;
  if (!first) return "Nothing was measured.";
  const target = headline_target(model.cases);
  const error = model.error_targets[target] ?? 0;
  if (!rest.length) return `${first.scenario}, ${first.variant}: ${winner(first, target, error)}`;
  const factors = factors_over(model.cases, target);
  const [best] = [...factors].sort((a, b) => b.fastest - a.fastest);
  if (!best?.fastest) return `No method gets within ${target_name(error)} in any of ${count(model.cases.length, "case")}.`;
  const there = factors.filter(({ engine }) => !engine.label.includes(":")).map(({ engine, reached }) => `${timed_label(engine)} in ${reached}`);
  return `To ${target_name(error)}, ${timed_label(best.engine)} is the fastest in ${best.fastest} of ${count(model.cases.length, "case")}. Cases in which an engine gets there: ${enumerate(there)}.`;
}

function failed(failures: Failure[]): HTMLElement {
  const text = ({ engine, failed, jobs, first, why }: Failure): string => `${engine} failed in ${failed} of ${count(jobs, "job")}, first in ${first}: ${why}`;
  return h("section", { id: "failures" }, h("h2", {}, "Engines that failed"), h("ul", {}, ...failures.map((one) => h("li", {}, text(one)))));
}

export function speed(study: Study): StudyView {
  const model = speed_model(study);
  const few = few_of(model.cases);
  const scenarios = [...new Set(model.cases.map(({ scenario }) => scenario))];
  const absent = model.without_truth.length
    ? h("p", { class: "absence" }, `No truth for ${enumerate(model.without_truth)}.`)
    : null;
  return {
    sentence: sentence(model),
    sections: [
      ...(model.cases.length > 1 ? [{ id: "overall", name: "All cases", content: () => overall(model) }] : []),
      ...scenarios.map((name) => ({
        id: slug(name),
        name,
        content: () => h(
          "section",
          { id: slug(name), class: "chapter" },
          h("h2", {}, name),
          ...model.cases.filter(({ scenario }) => scenario === name).map((item) => case_section(model, few, item)),
        ),
      })),
      { id: "orders", name: "Orders", content: () => orders(model) },
      ...(model.failures.length ? [{ id: "failures", name: "Failures", content: () => failed(model.failures) }] : []),
      ...(absent ? [{ id: "absent", name: "Without truth", content: () => h("section", { id: "absent" }, h("h2", {}, "Without a truth"), absent) }] : []),
    ],
  };
}
