// The verdict table: what physics expects, what each engine did, and how much of the allowed error that took.
import type { TruthCheck } from "../data";
import { h, table } from "../dom";
import { count, given, number, share, to_tolerance, words } from "../format";
import { ratio, type Case, type Entry } from "../model";
import { badge, gauge } from "./pieces";

const heads = ["engine", "expected", "measured", "error", "allowed", "share of allowed", "verdict"];

/** Longer tables open when asked, or when something is wrong. */
const most_open = 12;

const subject = (check: TruthCheck): string => `${check.body ? `${check.body}, ` : ""}${words(check.quantity)}`;

const check_key = (check: TruthCheck): string => JSON.stringify([check.body, check.quantity, check.time, check.source]);

function head_row(check: TruthCheck): HTMLTableRowElement {
  const title = h("strong", {}, `${subject(check)} at ${given(check.time, "s")}`);
  return h("tr", { class: "subject" }, h("th", { colspan: String(heads.length), scope: "colgroup" }, title, h("span", {}, check.source)));
}

function row(entry: Entry, check: TruthCheck): HTMLTableRowElement {
  const { unit } = check;
  const cells = [
    to_tolerance(check.expected, check.tolerance, unit),
    to_tolerance(check.measured, check.tolerance, unit),
    number(check.error, unit, 2),
    number(check.tolerance, unit, 2),
    h("span", { class: "share" }, gauge(ratio(check)), share(ratio(check))),
    badge(check.passed ? "right" : "wrong"),
  ];
  return h(
    "tr",
    {},
    h("th", { scope: "row" }, entry.contender.label),
    ...cells.map((content, index) => h("td", { "data-label": heads[index + 1] }, content)),
  );
}

export function checks(place: Case): HTMLElement | null {
  const subjects = new Map<string, { entry: Entry; check: TruthCheck }[]>();
  for (const entry of place.entries) {
    for (const check of entry.run.truth) {
      if (entry.contender.exact) continue;
      const key = check_key(check);
      subjects.set(key, [...(subjects.get(key) ?? []), { entry, check }]);
    }
  }
  const all = [...subjects.values()].flat();
  if (!all.length) return null;
  const rows = [...subjects.values()].flatMap((group) => [
    ...group.slice(0, 1).map(({ check }) => head_row(check)),
    ...group.map(({ entry, check }) => row(entry, check)),
  ]);
  const failed = all.filter(({ check }) => !check.passed).length;
  const summary = `Against the truth: ${count(all.length, "check")}, ${failed ? `${failed} outside what is allowed` : "all within what is allowed"}`;
  return h("details", { ...(failed || all.length <= most_open ? { open: "" } : {}), class: "checks" }, h("summary", {}, summary), table("Against the truth", heads, rows, "checks"));
}
