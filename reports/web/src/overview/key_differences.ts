// How far apart two engines are in energy, momentum and rest: one row a case, for two engines to choose.
import { watch } from "../address";
import type { KeyDifferences, RelativeDifference } from "../data";
import { h, slug, table, type Child } from "../dom";
import { given, number, percent } from "../format";
import { apart, type Apart, type Case, type Engine, type Model } from "../model";
import { right_share, ruler } from "../pieces";
import { select, type CurrentView } from "./filters";

interface Row extends Apart {
  item: Case;
}

interface Order {
  name: string;
  of: (key: KeyDifferences) => number; // largest first
}

const orders: Order[] = [
  { name: "energy", of: ({ energy }) => energy.largest ?? Infinity },
  { name: "momentum", of: ({ momentum }) => momentum.largest ?? Infinity },
  { name: "angular momentum", of: ({ angular_momentum }) => angular_momentum.largest ?? Infinity },
  { name: "rest", of: ({ rest_a, rest_b }) => Math.abs((rest_a ?? 1e9) - (rest_b ?? 1e9)) },
  { name: "overlap", of: ({ overlap_a, overlap_b }) => Math.max(overlap_a ?? 0, overlap_b ?? 0) },
  { name: "first divergence", of: ({ diverged_at }) => -(diverged_at ?? Infinity) },
];

function sorted(rows: Row[], name: string | null): Row[] {
  const order = orders.find((one) => one.name === name);
  if (!order) return rows;
  const value = ({ key }: Row): number => (key ? order.of(key) : -Infinity);
  return [...rows].sort((x, y) => (value(x) === value(y) ? 0 : value(y) - value(x)));
}

const difference = ({ largest, end }: RelativeDifference): Child[] => [
  h("span", { class: "ratio" }, ruler(largest), percent(largest)),
  percent(end) === percent(largest) ? null : h("span", { class: "end" }, percent(end)),
];

const since = (time: number): string => (time === 0 ? "throughout" : given(time, "s", 3));

function rest({ rest_a, rest_b }: KeyDifferences, a: Engine, b: Engine): Child[] {
  if (rest_a === null && rest_b === null) return [h("span", { class: "quiet-word" }, "neither")];
  if (rest_a !== null && rest_b !== null) {
    const times = rest_a === rest_b ? since(rest_a) : `${since(rest_a)}, ${since(rest_b)}`;
    return ["both ", h("span", { class: "end" }, times)];
  }
  const [name, time] = rest_a !== null ? [a.label, rest_a] : [b.label, rest_b ?? 0];
  return [h("strong", {}, `only ${name} `), h("span", { class: "end" }, since(time))];
}

const least_depth = 0.001; // mm

function depth(value: number | null): string {
  if (value === null) return "\u2013";
  return value > 0 && 1000 * value < least_depth ? `< ${least_depth}` : number(1000 * value, "", 2);
}

function row_of({ item, key, reason }: Row, a: Engine, b: Engine, heads: string[]): HTMLTableRowElement {
  const name = [item.scenario, item.variant].filter(Boolean).join(": ");
  const head = h("th", { scope: "row" }, h("a", { href: `#${slug(item.scenario, item.variant)}` }, name));
  if (!key) return h("tr", {}, head, h("td", { colspan: String(heads.length - 1) }, h("span", { class: "reason" }, reason)));
  const cells: Child[][] = [
    difference(key.energy),
    difference(key.momentum),
    difference(key.angular_momentum),
    rest(key, a, b),
    [`${depth(key.overlap_a)}, ${depth(key.overlap_b)}`],
    [key.diverged_at === null ? h("span", { class: "quiet-word" }, "never") : given(key.diverged_at, "s", 3)],
  ];
  return h("tr", {}, head, ...cells.map((cell, index) => h("td", { "data-label": heads[index + 1] }, h("span", { class: "both" }, ...cell))));
}

const most_named = 6;

/** "in 5 (arch 0.12, rain seed 2)", each a link */
function named(rows: Row[]): Child[] {
  const links = rows
    .slice(0, most_named)
    .flatMap(({ item }, index): Child[] => [index ? ", " : "", h("a", { href: `#${slug(item.scenario, item.variant)}` }, `${item.scenario} ${item.variant}`)]);
  return [`in ${rows.length}`, ...(links.length ? [" (", ...links, rows.length > most_named ? " \u2026)" : ")"] : [])];
}

function summary(rows: Row[], a: Engine, b: Engine): HTMLElement {
  const found = rows.flatMap((row) => (row.key ? [{ row, key: row.key }] : []));
  const near = (of: (key: KeyDifferences) => RelativeDifference): string => {
    const known = found.flatMap(({ key }) => of(key).largest ?? []);
    return `${known.filter((largest) => largest <= right_share).length} of ${known.length}`;
  };
  const resting = (fits: (key: KeyDifferences) => boolean): Row[] => found.filter(({ key }) => fits(key)).map(({ row }) => row);
  return h(
    "p",
    { class: "lede" },
    `${a.label} and ${b.label} stay within 1 % of each other in energy in ${near((key) => key.energy)} cases, `,
    `in momentum in ${near((key) => key.momentum)} and in angular momentum in ${near((key) => key.angular_momentum)}. `,
    `Both come to rest in ${resting((key) => key.rest_a !== null && key.rest_b !== null).length}, only ${a.label} `,
    ...named(resting((key) => key.rest_a !== null && key.rest_b === null)),
    `, only ${b.label} `,
    ...named(resting((key) => key.rest_a === null && key.rest_b !== null)),
    ".",
  );
}

/** The engines, with one of them first. */
const choices = (engines: Engine[], first: Engine): { value: string; name: string }[] =>
  [first, ...engines.filter((engine) => engine !== first)].map(({ label }, index) => ({ value: index ? label : "", name: label }));

/** Empty if there are no two engines. */
export function key_differences(model: Model): HTMLElement[] {
  const { engines } = model;
  const cases = model.chapters.flatMap((chapter) => chapter.cases);
  const ran = engines.filter((engine) => cases.some(({ entries }) => entries.some((entry) => entry.engine === engine && entry.run.status === "ok")));
  const [first, second] = ran;
  if (!first || !second) return [];
  const other = ran.find((engine) => engine !== first && engine.label === "box2d") ?? second;
  let view = new URLSearchParams();
  const current: CurrentView = () => view;
  const controls = [
    select("a", "compare", choices(engines, first), current),
    select("b", "with", choices(engines, other), current),
    select("by", "largest first", [{ value: "", name: "as listed" }, ...orders.map(({ name }) => ({ value: name, name }))], current),
  ];
  const about = h("div", {});
  const holder = h("div", { class: "apart" });
  watch((next) => {
    view = next;
    for (const control of controls) control.update(view);
    const of = (key: string, otherwise: Engine): Engine => engines.find(({ label }) => label === view.get(key)) ?? otherwise;
    const [a, b] = [of("a", first), of("b", other)];
    const rows = cases.flatMap((item): Row[] => {
      const found = a === b ? undefined : apart(item, a, b);
      return found ? [{ item, ...found }] : [];
    });
    const caption = `${a.label} and ${b.label}, case by case`;
    const heads = ["case", "energy: largest, end", "momentum: largest, end", "angular: largest, end", "at rest since", "overlap (mm)", "1 cm apart at"];
    about.replaceChildren(rows.length ? summary(rows, a, b) : h("p", { class: "absence" }, "No case has both."));
    holder.replaceChildren(...(rows.length ? [table(caption, heads, sorted(rows, view.get("by")).map((row) => row_of(row, a, b, heads)))] : []));
  });
  return [
    h("h2", {}, "How far apart"),
    about,
    h("div", { class: "filters", role: "group", "aria-label": "Engines to compare" }, ...controls.map(({ element }) => element)),
    holder,
    h(
      "p",
      { class: "basis" },
      "Energy, momentum and angular momentum: the largest difference over the run and that at its end (one number if they are the same), relative to the scene\u2019s own scale; the tick on the bar is 1 %. ",
      "At rest: slower than 1 cm/s and 0.01 rad/s until the end. Overlap: the deepest of the run. Of two times or overlaps, the first is that of the engine chosen first.",
    ),
  ];
}
