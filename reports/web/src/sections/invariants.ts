// What holds whatever the scene: a row for each run, a column for each law, with how much of what is allowed it took.
import type { InvariantCheck } from "../data";
import { h, table } from "../dom";
import { folded } from "../folded";
import { count, number, share, words } from "../format";
import { law_ratio, type Case } from "../model";
import { gauge } from "./pieces";

/** "0.012 N s of ground - box at 0.5 s, allowed 0.003 N s" */
export function evidence({ value, allowed, unit, where, time }: InvariantCheck): string {
  const place = where ? ` of ${where}` : "";
  return `${number(value, unit, 2)}${place} at ${number(time, "s")}, allowed ${number(allowed, unit, 2)}`;
}

function cell(name: string, check: InvariantCheck | undefined): HTMLTableCellElement {
  const attributes = { "data-label": words(name) };
  if (!check) return h("td", attributes, "does not apply");
  if (check.status === "not reported") return h("td", attributes, "not reported");
  const ratio = law_ratio(check);
  const title = evidence(check);
  const size = h("span", { class: "share", title }, gauge(ratio), share(ratio));
  return h("td", attributes, size, check.status === "broken" ? h("span", { class: "reason" }, title) : null);
}

export function invariants(place: Case): HTMLElement | null {
  const runs = place.entries.filter(({ run }) => run.invariants.length);
  if (!runs.length) return null;
  const names = [...new Set(runs.flatMap(({ run }) => run.invariants.map(({ name }) => name)))].sort();
  const rows = () => runs.map(({ engine, run }) => {
    const of = new Map(run.invariants.map((check) => [check.name, check]));
    return h("tr", { "data-of": engine.label }, h("th", { scope: "row" }, engine.label), ...names.map((name) => cell(name, of.get(name))));
  });
  const broken = runs.flatMap(({ run }) => run.invariants).filter(({ status }) => status === "broken").length;
  const caption = "What holds in any case";
  return folded(
    `${caption}: ${broken ? `${count(broken, "time")} broken` : "nothing broken"}`,
    () => [table(caption, ["engine", ...names.map(words)], rows())],
    { kind: "checks", open: broken > 0 },
  );
}
