// The charts of a case, each with a sentence that sums it up.
import { enumerate, given, number, to_within } from "../format";
import { rest_of, type Case, type Entry } from "../model";
import type { Cursor } from "./cursor";
import { figure } from "./figure";
import { over_time, type OverTime } from "./over_time";

type Column = OverTime["column"];

const last = (values: (number | null)[]): number | null => {
  for (let index = values.length - 1; index >= 0; --index) {
    const value = values[index];
    if (typeof value === "number") return value;
  }
  return null;
};

const largest = (values: (number | null)[]): number =>
  values.reduce<number>((most, value) => Math.max(most, Math.abs(value ?? 0)), 0);

/** Values closer than this fraction of the largest value look the same and are called the same. */
const same = 1e-3;

/** "At the end: impulse at 12.3 J, box2d at 12.1 J and the truth at 12.4 J." */
function ends(entries: Entry[], column: Column, unit: string): string {
  const found = entries.flatMap(({ engine, series }) => {
    const value = series ? last(series[column]) : null;
    return value === null ? [] : [{ name: engine.exact ? "the truth" : engine.label, value }];
  });
  if (!found.length) return "";
  const values = found.map(({ value }) => value);
  const spread = Math.max(...values) - Math.min(...values);
  const size = Math.max(...entries.map(({ series }) => (series ? largest(series[column]) : 0)));
  if (found.length > 1 && spread <= same * size) {
    const value = values[values.length - 1] ?? 0;
    return `At the end all are at ${number(Math.abs(value) <= same * size ? 0 : value, unit)}.`;
  }
  return `At the end: ${enumerate(found.map(({ name, value }) => `${name} at ${to_within(value, spread, unit)}`))}.`;
}

function energy({ entries, horizon }: Case, cursor: Cursor): HTMLElement {
  const chart: OverTime = { quantity: "energy", unit: "J", entries, column: "energy", horizon, cursor };
  return figure({
    title: "Energy of the whole scene",
    note: ends(entries, "energy", "J"),
    height: 220,
    log: false,
    draw: (width, log) => [over_time(width, { ...chart, log })],
  });
}

const components: { column: Column; quantity: string; unit: string }[] = [
  { column: "momentum_x", quantity: "horizontal momentum", unit: "kg m/s" },
  { column: "momentum_y", quantity: "vertical momentum", unit: "kg m/s" },
  { column: "angular_momentum", quantity: "angular momentum", unit: "kg m^2/s" },
];

const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** Components that are zero except for round-off are named, not drawn. */
function momenta({ entries, horizon }: Case, cursor: Cursor): HTMLElement[] {
  const size = (column: Column) => Math.max(0, ...entries.map(({ series }) => (series ? largest(series[column]) : 0)));
  const most = Math.max(...components.map(({ column }) => size(column)));
  const moving = components.filter(({ column }) => most > 0 && size(column) > 1e-6 * most);
  const still = components.filter((component) => !moving.includes(component)).map(({ quantity }) => quantity);
  const zero = still.length ? ` ${capital(enumerate(still))}: zero throughout.` : "";
  if (!moving.length) return [figure({ title: "Momentum", note: zero.trim(), height: 0, draw: () => [] })];
  return moving.map((component, index) =>
    figure({
      title: `${capital(component.quantity)} of the whole scene`,
      note: ends(entries, component.column, component.unit) + (index ? "" : zero),
      height: 220,
      draw: (width) => [over_time(width, { ...component, entries, horizon, cursor })],
    }),
  );
}

const still_speed = 0.01; // m/s; a body that is slower, and turns by less than 0.01 rad/s, is at rest
const least_speed = 1e-6; // m/s

/** "At rest: impulse since 2.67 s and box2d never." */
function rests(item: Case): string {
  const found = item.entries.flatMap((entry) => {
    const since = entry.series ? rest_of(item, entry) : undefined;
    if (since === undefined) return [];
    const name = entry.engine.exact ? "the truth" : entry.engine.label;
    return [{ name, when: since === null ? "never" : since === 0 ? "throughout" : `since ${given(since, "s", 3)}` }];
  });
  if (!found.length) return "";
  const same = found.every(({ when }) => when === found[0]?.when);
  if (same) return found[0]?.when === "never" ? "Not at rest at the end." : `At rest ${found[0]?.when ?? ""}.`;
  return `At rest: ${enumerate(found.map(({ name, when }) => `${name} ${when}`))}.`;
}

function rest(item: Case, cursor: Cursor): HTMLElement {
  const chart: OverTime = {
    quantity: "speed",
    unit: "m/s",
    entries: item.entries,
    column: "fastest",
    floor: least_speed,
    limit: { value: still_speed, name: "at rest below" },
    horizon: item.horizon,
    cursor,
  };
  return figure({ title: "Speed of the fastest body", note: rests(item), height: 220, log: true, draw: (width, log) => [over_time(width, { ...chart, log })] });
}

function pose({ entries, horizon }: Case, cursor: Cursor): HTMLElement {
  const engines = entries.filter(({ engine, series }) => !engine.exact && series);
  const sizes = engines.map(({ engine, series }) => `${engine.label} ${number(largest(series?.pose_difference ?? []), "m")}`);
  const differ = engines.some(({ series }) => largest(series?.pose_difference ?? []) > 0);
  const against = entries.some(({ engine }) => engine.exact) ? "from the truth" : "between the engines";
  return figure({
    title: `Pose difference ${against}`,
    note: differ ? `Largest: ${enumerate(sizes)}.` : "None at any time.",
    height: 220,
    ...(differ ? { log: true } : {}),
    draw: (width, log) =>
      differ ? [over_time(width, { quantity: "pose difference", unit: "m", entries, column: "pose_difference", log, horizon, cursor })] : [],
  });
}

/** Empty if bodies never overlap. */
function overlap({ entries, horizon }: Case, cursor: Cursor): HTMLElement[] {
  const engines = entries.filter(({ engine, series }) => !engine.exact && series);
  // The metric of the run, from every step; the chart may have fewer.
  const most = engines.map(({ engine, series, run }) => ({ engine, depth: run.metrics["penetration_max"]?.value ?? largest(series?.overlap ?? []) }));
  if (!most.some(({ depth }) => depth > 0)) return [];
  const chart: OverTime = { quantity: "overlap", unit: "m", entries, column: "overlap", horizon, cursor };
  const sizes = most.map(({ engine, depth }) => `${engine.label} ${number(depth, "m", 2)}`);
  return [
    figure({
      title: "Deepest overlap of two bodies",
      note: `Largest: ${enumerate(sizes)}.`,
      height: 220,
      log: false,
      draw: (width, log) => [over_time(width, { ...chart, log })],
    }),
  ];
}

export function case_charts(item: Case, cursor: Cursor): HTMLElement[] {
  if (!item.entries.some(({ series }) => series)) return [];
  return [energy(item, cursor), ...momenta(item, cursor), rest(item, cursor), pose(item, cursor), ...overlap(item, cursor)];
}
