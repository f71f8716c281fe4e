// The checks of a case: the reason for each engine's verdict in one line, the table of readings against the truth, and
// the table of invariants.
import type { InvariantCheck, TruthCheck } from "../data";
import { h, slug, table } from "../dom";
import { folded } from "../folded";
import { count, given, number, ratio_text, to_within, words } from "../format";
import { ratio_of, type Case, type Entry } from "../model";
import { badge, gauge } from "../pieces";

interface Reading {
  entry: Entry;
  check: TruthCheck;
}

const heads = ["reading", "engine", "expected", "measured", "error", "tolerance", "error / tolerance", "verdict"];

/** Longer tables start folded, unless a check fails. */
const most_open = 12;

/** Groups the same reading of all engines. The k-th apex is one reading, although engines reach it at different times. */
function readings(item: Case): Reading[][] {
  const groups = new Map<string, Reading[]>();
  for (const entry of item.entries) {
    if (entry.engine.exact) continue;
    const seen = new Map<string, number>();
    for (const check of entry.run.truth) {
      const kind = JSON.stringify([check.body, check.quantity, check.source]);
      const count = (seen.get(kind) ?? 0) + 1;
      seen.set(kind, count);
      const key = `${kind} ${count}`;
      groups.set(key, [...(groups.get(key) ?? []), { entry, check }]);
    }
  }
  return [...groups.values()];
}

function subject(group: Reading[], check: TruthCheck): HTMLElement {
  const body = check.body ? `${check.body}, ` : "";
  const times = group.map((reading) => reading.check.time);
  const [first, last] = [Math.min(...times), Math.max(...times)];
  const when = first === last ? given(first, "s", 4) : `${given(first, "", 4)} to ${given(last, "s", 4)}`;
  const title = h("strong", {}, `${body}${words(check.quantity)} at ${when}`);
  return h("th", { scope: "rowgroup", rowspan: String(group.length), class: "subject" }, title, h("span", {}, check.source));
}

function cells({ entry, check }: Reading): HTMLElement[] {
  const { unit } = check;
  const difference = Math.max(check.error ?? 0, check.tolerance ?? 0);
  const contents = [
    (check.relation === "equal" ? "" : `${check.relation} `) + to_within(check.expected, difference, unit),
    check.reported ? to_within(check.measured, difference, unit) : "not reported",
    check.reported ? number(check.error, unit, 2) : "",
    number(check.tolerance, unit, 2),
    check.reported ? h("span", { class: "ratio" }, gauge(ratio_of(check)), ratio_text(ratio_of(check))) : "",
    check.reported ? badge(check.passed ? "right" : "wrong") : "",
  ];
  return [
    h("th", { scope: "row" }, entry.engine.label),
    ...contents.map((content, index) => h("td", { "data-label": heads[index + 2] }, content)),
  ];
}

const rows_of = (group: Reading[]): HTMLTableRowElement[] =>
  group.map((reading, index) => {
    const first = index === 0;
    const attributes = { "data-engine": reading.entry.engine.label, ...(first ? { class: "first" } : {}) };
    return h("tr", attributes, first ? subject(group, reading.check) : null, ...cells(reading));
  });

export function checks(item: Case): HTMLElement | null {
  const groups = readings(item);
  const all = groups.flat();
  if (!all.length) return null;
  const failed = all.filter(({ check }) => check.reported && !check.passed).length;
  const outcome = failed ? `${failed} outside tolerance` : "all within tolerance";
  return folded(
    `Against the truth: ${count(all.length, "check")}, ${outcome}`,
    () => [table("Against the truth", heads, groups.flatMap(rows_of), "grouped")],
    { kind: "checks", open: failed > 0 || all.length <= most_open },
  );
}

/** "0.012 N s of ground - box at 0.5 s, tolerance 0.003 N s" */
function largest_error({ value, tolerance, unit, where, time }: InvariantCheck): string {
  const subject = where ? ` of ${where}` : "";
  return `${number(value, unit, 2)}${subject} at ${number(time, "s")}, tolerance ${number(tolerance, unit, 2)}`;
}

function cell(name: string, check: InvariantCheck | undefined): HTMLTableCellElement {
  const attributes = { "data-label": words(name) };
  if (!check) return h("td", attributes, "does not apply");
  if (check.status === "not reported") return h("td", attributes, "not reported");
  const ratio = ratio_of(check);
  const title = largest_error(check);
  const size = h("span", { class: "ratio", title }, gauge(ratio), ratio_text(ratio));
  return h("td", attributes, size, check.status === "broken" ? h("span", { class: "reason" }, title) : null);
}

export function invariants(item: Case): HTMLElement | null {
  const runs = item.entries.filter(({ run }) => run.invariants.length);
  if (!runs.length) return null;
  const names = [...new Set(runs.flatMap(({ run }) => run.invariants.map(({ name }) => name)))].sort();
  const rows = () => runs.map(({ engine, run }) => {
    const of = new Map(run.invariants.map((check) => [check.name, check]));
    return h("tr", { "data-engine": engine.label }, h("th", { scope: "row" }, engine.label), ...names.map((name) => cell(name, of.get(name))));
  });
  const broken = runs.flatMap(({ run }) => run.invariants).filter(({ status }) => status === "broken").length;
  const caption = "Invariants";
  return folded(
    `${caption}: ${broken ? `${broken} broken` : "none broken"}`,
    () => [table(caption, ["engine", ...names.map(words)], rows())],
    { kind: "checks", open: broken > 0 },
  );
}

interface Finding {
  ratio: number;
  text: string;
}

function findings_of({ run }: Entry): Finding[] {
  const truth = run.truth
    .filter(({ reported }) => reported)
    .map((check) => ({
      ratio: ratio_of(check),
      text: `${check.body ? `${check.body}, ` : ""}${words(check.quantity)} at ${given(check.time, "s", 4)}, error ${number(check.error, check.unit, 2)}, tolerance ${number(check.tolerance, check.unit, 2)}`,
    }));
  const invariants = run.invariants
    .filter(({ status }) => status !== "not reported")
    .map((check) => ({ ratio: ratio_of(check), text: `${words(check.name)}, ${largest_error(check)}` }));
  return [...truth, ...invariants];
}

function reason(entry: Entry): string {
  const { run } = entry;
  if (run.status !== "ok") return run.reason;
  const [most] = findings_of(entry).sort((a, b) => b.ratio - a.ratio);
  if (!most) return "There is no check for this case.";
  if (most.ratio === 0) return "No error in any check.";
  return `Largest error / tolerance ${ratio_text(most.ratio)}: ${most.text}.`;
}

/** The reason for each engine's verdict; cells of the overview link here. */
export function verdict_list(item: Case): HTMLElement | null {
  const engines = item.entries.filter(({ engine }) => !engine.exact);
  if (!engines.length) return null;
  const items = engines.map((entry) => {
    const { label } = entry.engine;
    const id = slug(item.scenario, item.variant, label);
    return h("li", { id, "data-marks": label }, badge(entry.run.verdict), h("span", {}, h("strong", {}, label), ` ${reason(entry)}`));
  });
  return h("ul", { class: "verdicts" }, ...items);
}
