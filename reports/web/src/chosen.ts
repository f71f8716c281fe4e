// The engines that the address's view chooses, for all charts and tables of the page at once: by the overview's filters
// (engine, method), or by a legend (only). None chosen means all, or those that a crowded chart starts with.
import { current_view, show_here, type View } from "./address";
import type { Engine } from "./model";

const everything = "*";

/** Engines that a chart with many of them starts with, by label. */
export type Few = ReadonlySet<string> | undefined;

function by_legend({ label }: Engine, view: View, few: Few): boolean {
  const only = view.getAll("only");
  if (!only.length) return few?.has(label) ?? true;
  return only.includes(everything) || only.includes(label);
}

export function shows_engine(view: View, engine: Engine, few?: Few): boolean {
  const among = (key: string, value: string): boolean => !view.has(key) || view.getAll(key).includes(value);
  return engine.exact || (among("engine", engine.engine) && among("method", engine.method) && by_legend(engine, view, few));
}

/** The items whose engine is chosen; all, if none is: a chart is never empty. */
export function chosen<Item extends { engine: Engine }>(items: Item[], few?: Few): Item[] {
  const view = current_view();
  const found = items.filter(({ engine }) => shows_engine(view, engine, few));
  return found.some(({ engine }) => !engine.exact) ? found : items;
}

/** What decides which engines are chosen. */
export const choice_of = (view: View): string => ["engine", "method", "only"].map((key) => view.getAll(key).join("\n")).join("\n\n");

/** Adds an engine to those chosen, or takes it out. The first choice isolates it. */
export function toggle(label: string): void {
  const view = new URLSearchParams(current_view());
  const only = new Set(view.getAll("only").filter((one) => one !== everything));
  if (!only.delete(label)) only.add(label);
  set_only(view, [...only]);
}

export function choose_all(): void {
  set_only(new URLSearchParams(current_view()), [everything]);
}

function set_only(view: View, labels: string[]): void {
  view.delete("only");
  for (const label of labels) view.append("only", label);
  show_here(view);
}
