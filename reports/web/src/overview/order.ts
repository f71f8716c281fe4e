// The order of the overview's rows. A view names what they are sorted by; "-" before it turns the order around.
import type { View } from "../address";
import type { Case, Engine, Model } from "../model";
import type { Measure } from "./measures";

export interface Key {
  id: string;
  name: string;
}

export const largest: Key = { id: "largest", name: "largest of a row" };
export const scenario: Key = { id: "scenario", name: "scenario" };
export const variant: Key = { id: "case", name: "case" };
export const key_of = ({ label }: Engine): Key => ({ id: `of ${label}`, name: label });

export const keys = (engines: Engine[]): Key[] => [scenario, variant, largest, ...engines.map(key_of)];

export interface Sorting {
  id: string; // "": as listed
  down: boolean;
}

export function sorting(view: View): Sorting {
  const asked = view.get("sort") ?? "";
  return asked.startsWith("-") ? { id: asked.slice(1), down: true } : { id: asked, down: false };
}

const text = (a: string, b: string): number => a.localeCompare(b, "en", { numeric: true });

type Compare = (a: Case, b: Case) => number;

/** Whatever the direction, rows without a value come last. */
function by_number(value: (place: Case) => number, turn: number): Compare {
  return (a, b) => {
    const [x, y] = [value(a), value(b)];
    if (Number.isNaN(x) || Number.isNaN(y)) return Number(Number.isNaN(x)) - Number(Number.isNaN(y));
    return x === y ? 0 : turn * (x < y ? -1 : 1);
  };
}

function compare(model: Model, { id, down }: Sorting, measure: Measure): Compare {
  const turn = down ? -1 : 1;
  if (id === scenario.id) return (a, b) => turn * text(a.scenario, b.scenario);
  if (id === variant.id) return (a, b) => turn * text(a.variant, b.variant);
  const wanted = model.engines.filter((engine) => !engine.exact && (id === largest.id || id === key_of(engine).id));
  const value = (place: Case): number => {
    const found = place.entries.filter(({ engine }) => wanted.includes(engine)).map(measure.of);
    const known = found.filter((one) => !Number.isNaN(one));
    return known.length ? Math.max(...known) : NaN;
  };
  return by_number(value, turn);
}

/** All cases, as listed or as the view sorts them. */
export function ordered(model: Model, asked: Sorting, measure: Measure): Case[] {
  const cases = model.chapters.flatMap((chapter) => chapter.cases);
  return asked.id ? cases.sort(compare(model, asked, measure)) : cases;
}
