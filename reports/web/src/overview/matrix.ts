// The overview's table: every case against every engine, with a verdict and a number in each cell and a link to its
// reason. The address's view chooses the number and the order of the rows; "-" before a sort key reverses the order.
import { show, type View } from "../address";
import { h, slug, type Child } from "../dom";
import { number, percent, ratio_text } from "../format";
import { mark_of, type Case, type Engine, type Entry, type Model } from "../model";
import { badge, gauge, ruler } from "../pieces";

export interface Measure {
  name: string;
  about: string;
  of: (entry: Entry) => number; // NaN if there is none
  shown: (entry: Entry) => Child;
}

const plain = (value: (entry: Entry) => number | null | undefined, unit: string): Pick<Measure, "of" | "shown"> => ({
  of: (entry) => value(entry) ?? NaN,
  shown: (entry) => {
    const found = value(entry);
    return typeof found === "number" ? h("span", {}, number(found, unit)) : null;
  },
});

const largest_error: Measure = {
  name: "error / tolerance",
  about: "Each number is the largest error / tolerance of a run, over its readings and invariants; the tick on the bar is 1, the limit.",
  of: ({ run, worst }) => (run.status === "failed" ? Infinity : worst),
  shown: ({ worst }) => (Number.isNaN(worst) ? null : h("span", { class: "ratio" }, gauge(worst), ratio_text(worst))),
};

const farthest: Measure = {
  name: "error / scale",
  about:
    "Each number is the largest error of a run, relative to what the truth says changes in the scene: the same ruler for every engine; the tick on the bar is 1 %. The verdict says whether the engine\u2019s method explains it.",
  of: ({ run, farthest }) => (run.status === "failed" ? Infinity : farthest),
  shown: ({ farthest }) => (Number.isNaN(farthest) ? null : h("span", { class: "ratio" }, ruler(farthest), percent(farthest))),
};

/** The first is the default. */
export const measures: readonly [Measure, ...Measure[]] = [
  farthest,
  largest_error,
  {
    name: "distance from the truth",
    about: "Each number is the distance of a run\u2019s bodies from the truth, root mean square over bodies and time.",
    ...plain(({ run }) => run.metrics["truth_error_rms"]?.value, "m"),
  },
  {
    name: "time per step",
    about: "Each number is the time of the engine\u2019s own step, the median over the repetitions. Under its name stands how its code runs, if that is not native: WebAssembly, compiled just in time (JIT), or interpreted.",
    ...plain(({ timing }) => timing?.step_us, "\u00b5s"),
  },
  {
    name: "real-time factor",
    about: "Each number is the simulated time per second spent in steps.",
    ...plain(({ timing }) => timing?.real_time_factor, ""),
  },
];

export interface Key {
  id: string;
  name: string;
  mark?: string; // how an engine's code runs, if that is not native
}

const largest: Key = { id: "largest", name: "largest in the row" };
const scenario: Key = { id: "scenario", name: "scenario" };
const variant: Key = { id: "case", name: "case" };
const key_of = (engine: Engine): Key => ({ id: `of ${engine.label}`, name: engine.label, mark: mark_of(engine) });

export const keys = (engines: Engine[]): Key[] => [scenario, variant, largest, ...engines.map(key_of)];

export interface Sorting {
  id: string; // "": as listed
  down: boolean;
}

export function sorting(view: View): Sorting {
  const key = view.get("sort") ?? "";
  return key.startsWith("-") ? { id: key.slice(1), down: true } : { id: key, down: false };
}

const by_text = (a: string, b: string): number => a.localeCompare(b, "en", { numeric: true });

type Compare = (a: Case, b: Case) => number;

/** Rows without a value come last in either direction. */
function by_number(value: (item: Case) => number, sign: number): Compare {
  return (a, b) => {
    const [x, y] = [value(a), value(b)];
    if (Number.isNaN(x) || Number.isNaN(y)) return Number(Number.isNaN(x)) - Number(Number.isNaN(y));
    return x === y ? 0 : sign * (x < y ? -1 : 1);
  };
}

function compare(model: Model, { id, down }: Sorting, measure: Measure): Compare {
  const sign = down ? -1 : 1;
  if (id === scenario.id) return (a, b) => sign * by_text(a.scenario, b.scenario);
  if (id === variant.id) return (a, b) => sign * by_text(a.variant, b.variant);
  const wanted = model.engines.filter((engine) => !engine.exact && (id === largest.id || id === key_of(engine).id));
  const value = (item: Case): number => {
    const found = item.entries.filter(({ engine }) => wanted.includes(engine)).map(measure.of);
    const known = found.filter((one) => !Number.isNaN(one));
    return known.length ? Math.max(...known) : NaN;
  };
  return by_number(value, sign);
}

/** All cases in the order that the view asks for; without one, as they are listed. */
function ordered(model: Model, order: Sorting, measure: Measure): Case[] {
  const cases = model.chapters.flatMap((chapter) => chapter.cases);
  return order.id ? cases.sort(compare(model, order, measure)) : cases;
}

function cell(entry: Entry | undefined, item: Case, head: string, measure: Measure): HTMLTableCellElement {
  if (!entry) return h("td", { class: "none", "data-label": head }, "\u2013");
  const { run, engine } = entry;
  const why = run.status === "ok" ? null : h("span", { class: "reason" }, run.reason);
  const link = h("a", { href: `#${slug(item.scenario, item.variant, engine.label)}` }, badge(run.verdict), measure.shown(entry), why);
  return h("td", { "data-label": head, "data-verdict": run.verdict }, link);
}

/** A click sorts by the column, a second reverses the order, a third restores the listed order. */
function head(key: Key, view: View): HTMLTableCellElement {
  const { id, down } = sorting(view);
  const mine = id === key.id;
  const sign = h("span", { class: "direction", "aria-hidden": "true" }, mine ? (down ? "\u25be" : "\u25b4") : "\u25b4");
  const mark = key.mark ? h("small", { class: "execution" }, key.mark) : null;
  const button = h("button", { type: "button", ...(mine ? { class: "sorted" } : {}) }, key.name, mark, sign);
  button.addEventListener("click", () => {
    const next = new URLSearchParams(view);
    if (mine && !down) next.set("sort", `-${key.id}`);
    else if (mine) next.delete("sort");
    else next.set("sort", key.id);
    show(next);
    // The table was replaced.
    for (const button of document.querySelectorAll<HTMLElement>(".matrix thead button")) {
      if (button.firstChild?.textContent === key.name) button.focus();
    }
  });
  return h("th", { scope: "col", "aria-sort": mine ? (down ? "descending" : "ascending") : "none" }, button);
}

/** So many engines fit beside each other on a laptop with verdict and number on one line; of more, the number is below. */
const few = 4;

export function matrix(model: Model, engines: Engine[], view: View, measure: Measure): HTMLElement {
  let above = "";
  const rows = ordered(model, sorting(view), measure).map((item) => {
    const first = item.scenario !== above;
    above = item.scenario;
    const name = h("th", { scope: "row" }, first ? h("a", { href: `#${slug(item.scenario)}` }, item.scenario) : h("span", { class: "unseen" }, item.scenario));
    const to_case = h("a", { href: `#${slug(item.scenario, item.variant)}` }, item.variant);
    const row = h("tr", first ? { class: "first" } : {}, name, h("td", { class: "variant" }, to_case));
    for (const engine of engines) {
      row.append(cell(item.entries.find((entry) => entry.engine === engine), item, engine.label, measure));
    }
    return row;
  });
  const caption = "Verdicts by case and engine";
  const heads = [scenario, variant, ...engines.map(key_of)].map((key) => head(key, view));
  return h(
    "div",
    { class: "table verdicts-by-case", tabindex: "0", role: "group", "aria-label": caption },
    h("table", { class: engines.length > few ? "matrix grouped many" : "matrix grouped" }, h("caption", {}, caption), h("thead", {}, h("tr", {}, ...heads)), h("tbody", {}, ...rows)),
  );
}
