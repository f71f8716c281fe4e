// The checks of a case: the reason for each engine's verdict in one line, the table of readings against the truth, and
// the table of invariants.
import type { EngineNote, InvariantCheck, TruthCheck, Verdict } from "../data";
import { h, slug, table } from "../dom";
import { folded } from "../folded";
import { count, enumerate, given, number, percent, ratio_text, to_within, words } from "../format";
import { is_judged, ratio_of, relative_of, reported, type Case, type Entry } from "../model";
import { badge, gauge, right_share, ruler } from "../pieces";

interface Reading {
  entry: Entry;
  check: TruthCheck;
}

const heads = ["reading", "engine", "expected", "measured", "error", "error / scale", "tolerance", "error / tolerance", "verdict"];

/** Longer tables start folded; those with a check that fails may be longer. */
const most_open = { held: 12, failed: 48 };

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

/** error / tolerance with its bar, and whether the check could have failed at all. */
const tolerated = (check: TruthCheck | InvariantCheck, title?: string): HTMLElement =>
  h(
    "span",
    { class: "ratio", title },
    gauge(ratio_of(check)),
    ratio_text(ratio_of(check)),
    check.evidence ? null : h("span", { class: "no-test" }, "not a test"),
  );

/** Of one check, by the rules that give a run its verdict. */
function verdict_of(check: TruthCheck): Verdict {
  if (!check.passed) return "wrong";
  if (relative_of(check) > right_share) return "coarse";
  return check.evidence ? "right" : "no evidence";
}

function cells({ entry, check }: Reading): HTMLElement[] {
  const { unit } = check;
  const difference = Math.max(check.error ?? 0, check.tolerance ?? 0);
  const contents = [
    (check.relation === "equal" ? "" : `${check.relation} `) + to_within(check.expected, difference, unit),
    check.reported ? to_within(check.measured, difference, unit) : "not reported",
    check.reported ? number(check.error, unit, 2) : "",
    check.reported ? h("span", { class: "ratio" }, ruler(check.relative_error), percent(check.relative_error)) : "",
    number(check.tolerance, unit, 2),
    check.reported ? tolerated(check) : "",
    check.reported ? badge(verdict_of(check)) : "",
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
    { kind: "checks", open: all.length <= (failed ? most_open.failed : most_open.held) },
  );
}

/** "0.012 N s of ground - box at 0.5 s, tolerance 0.003 N s" */
function largest_error({ value, tolerance, unit, where, time, phases, detail }: InvariantCheck): string {
  const subject = where ? ` of ${where}` : "";
  const worst = phases ? `, worst of ${phases} phases` : "";
  return `${number(value, unit, 2)}${subject} at ${number(time, "s")}, tolerance ${number(tolerance, unit, 2)}${worst}${detail ? `; ${detail}` : ""}`;
}

function cell(name: string, check: InvariantCheck | undefined): HTMLTableCellElement {
  const attributes = { "data-label": words(name) };
  if (!check) return h("td", attributes, "does not apply");
  if (!is_judged(check)) return h("td", attributes, check.status);
  const title = largest_error(check);
  return h("td", attributes, tolerated(check, title), check.status === "broken" ? h("span", { class: "reason" }, title) : null);
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

const subject_of = (check: TruthCheck): string =>
  `${check.body ? `${check.body}, ` : ""}${words(check.quantity)} at ${given(check.time, "s", 4)}`;

/** "Off by 2.3 % of scale at most: ball, y at 2 s." */
function farthest_off(entry: Entry): string {
  const [most] = reported(entry.run).sort((a, b) => relative_of(b) - relative_of(a));
  return most && relative_of(most) > 0 ? `Off by ${percent(most.relative_error)} of scale at most: ${subject_of(most)}. ` : "";
}

/** "Not a test: y, energy." */
function untested({ run }: Entry): string {
  const checks = run.verdict === "no evidence" ? [...new Set(reported(run).filter(({ evidence }) => !evidence).map(({ quantity }) => words(quantity)))] : [];
  return checks.length ? ` The tolerance is too large for a test of ${enumerate(checks)}.` : "";
}

interface Finding {
  ratio: number;
  text: string;
}

function findings_of({ run }: Entry): Finding[] {
  const truth = reported(run).map((check) => ({
    ratio: ratio_of(check),
    text: `${subject_of(check)}, error ${number(check.error, check.unit, 2)}, tolerance ${number(check.tolerance, check.unit, 2)}`,
  }));
  const invariants = run.invariants
    .filter(is_judged)
    .map((check) => ({ ratio: ratio_of(check), text: `${words(check.name)}, ${largest_error(check)}` }));
  return [...truth, ...invariants];
}

function reason(entry: Entry): string {
  const { run } = entry;
  if (run.status !== "ok") return run.reason;
  const [most] = findings_of(entry).sort((a, b) => b.ratio - a.ratio);
  if (!most) return "There is no check for this case.";
  if (most.ratio === 0) return `No error in any check.${untested(entry)}`;
  const cure = run.verdict === "wrong" && run.reason ? ` ${run.reason.slice(0, 1).toUpperCase()}${run.reason.slice(1)}.` : "";
  return `${farthest_off(entry)}Largest error / tolerance ${ratio_text(most.ratio)}: ${most.text}.${untested(entry)}${cure}`;
}

function caveats(note: EngineNote | undefined): HTMLElement | null {
  const all = note?.caveats ?? [];
  return all.length ? folded("What it does differently", () => [h("ul", {}, ...all.map((caveat) => h("li", {}, caveat)))], { kind: "caveats" }) : null;
}

/** The reason for each engine's verdict; cells of the overview link here. */
export function verdict_list(item: Case, notes: EngineNote[]): HTMLElement | null {
  const engines = item.entries.filter(({ engine }) => !engine.exact);
  if (!engines.length) return null;
  const items = engines.map((entry) => {
    const { label } = entry.engine;
    const id = slug(item.scenario, item.variant, label);
    const note = notes.find(({ name }) => name === entry.engine.engine);
    const stated = note?.states?.find(({ method }) => method === entry.engine.method)?.text;
    const words = [h("strong", {}, label), ` ${reason(entry)}`, stated ? h("span", { class: "stated" }, ` It states: ${stated}.`) : null, caveats(note)];
    return h("li", { id, "data-marks": label }, badge(entry.run.verdict), h("span", {}, ...words));
  });
  return h("ul", { class: "verdicts" }, ...items);
}
