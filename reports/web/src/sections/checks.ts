// The verdict table: what physics expects, what each engine did, and how much of the allowed error that took.
import type { TruthCheck } from "../data";
import { h, table } from "../dom";
import { folded } from "../folded";
import { count, given, number, share, to_within, words } from "../format";
import { ratio, type Case, type Entry } from "../model";
import { badge, gauge } from "./pieces";

interface Answer {
  entry: Entry;
  check: TruthCheck;
}

const heads = ["reading", "engine", "expected", "measured", "error", "tolerance", "share of allowed", "verdict"];

/** Longer tables open when asked, or when something is wrong. */
const most_open = 12;

/** The same reading of every engine. The k-th apex is the same reading whenever each engine has it. */
function readings(place: Case): Answer[][] {
  const groups = new Map<string, Answer[]>();
  for (const entry of place.entries) {
    if (entry.engine.exact) continue;
    const seen = new Map<string, number>();
    for (const check of entry.run.truth) {
      const kind = JSON.stringify([check.body, check.quantity, check.source]);
      const place = (seen.get(kind) ?? 0) + 1;
      seen.set(kind, place);
      const key = `${kind} ${place}`;
      groups.set(key, [...(groups.get(key) ?? []), { entry, check }]);
    }
  }
  return [...groups.values()];
}

function subject(answers: Answer[], check: TruthCheck): HTMLElement {
  const body = check.body ? `${check.body}, ` : "";
  const times = answers.map((answer) => answer.check.time);
  const [first, last] = [Math.min(...times), Math.max(...times)];
  const when = first === last ? given(first, "s", 4) : `${given(first, "", 4)} to ${given(last, "s", 4)}`;
  const title = h("strong", {}, `${body}${words(check.quantity)} at ${when}`);
  return h("th", { scope: "rowgroup", rowspan: String(answers.length), class: "subject" }, title, h("span", {}, check.source));
}

function cells({ entry, check }: Answer): HTMLElement[] {
  const { unit } = check;
  const difference = Math.max(check.error ?? 0, check.tolerance ?? 0);
  const contents = [
    (check.relation === "equal" ? "" : `${check.relation} `) + to_within(check.expected, difference, unit),
    check.reported ? to_within(check.measured, difference, unit) : "not reported",
    check.reported ? number(check.error, unit, 2) : "",
    number(check.tolerance, unit, 2),
    check.reported ? h("span", { class: "share" }, gauge(ratio(check)), share(ratio(check))) : "",
    check.reported ? badge(check.passed ? "right" : "wrong") : "",
  ];
  return [
    h("th", { scope: "row" }, entry.engine.label),
    ...contents.map((content, index) => h("td", { "data-label": heads[index + 2] }, content)),
  ];
}

const rows = (answers: Answer[]): HTMLTableRowElement[] =>
  answers.map((answer, index) => {
    const first = index === 0;
    return h("tr", { "data-of": answer.entry.engine.label, ...(first ? { class: "first" } : {}) }, first ? subject(answers, answer.check) : null, ...cells(answer));
  });

export function checks(place: Case): HTMLElement | null {
  const groups = readings(place);
  const all = groups.flat();
  if (!all.length) return null;
  const failed = all.filter(({ check }) => check.reported && !check.passed).length;
  const outcome = failed ? `${failed} outside what is allowed` : "all within what is allowed";
  return folded(
    `Against the truth: ${count(all.length, "check")}, ${outcome}`,
    () => [table("Against the truth", heads, groups.flatMap(rows), "grouped")],
    { kind: "checks", open: failed > 0 || all.length <= most_open },
  );
}
