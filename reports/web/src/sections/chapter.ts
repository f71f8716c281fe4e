// One scenario: its question, and for each case its charts, checks and numbers.
import { case_charts } from "../charts/case";
import { Cursor } from "../charts/cursor";
import { legend } from "../charts/look";
import type { Measured, Report, Verdict } from "../data";
import { h, slug, table } from "../dom";
import { folded } from "../folded";
import { count, given, number, words } from "../format";
import { load_series, type Case, type Chapter, type Model } from "../model";
import { badge, case_command, command } from "../pieces";
import { replay_figure } from "../replay/view";
import { checks, invariants, verdict_list } from "./checks";

/** Up to when the case is predictable, and how the engines compare beyond. */
function horizon(item: Case): HTMLElement | null {
  if (item.horizon === undefined) return null;
  const compared = item.comparisons.filter(({ metrics }) => "horizon" in metrics);
  return h(
    "div",
    { class: "horizon" },
    h(
      "p",
      {},
      `This motion can be predicted for ${given(item.horizon, "s", 3)}; by then, runs that started 1 nm apart have diverged. `,
      "Beyond this horizon, ensembles of perturbed runs are compared instead of single runs.",
    ),
    h("ul", {}, ...compared.map(({ a, b, reason }) => h("li", {}, `${a} and ${b}: ${reason}`))),
  );
}

interface Column {
  head: string;
  metrics: Record<string, Measured>;
}

function metric_table(caption: string, columns: Column[], about: Map<string, string>): HTMLElement | null {
  const names = [...new Set(columns.flatMap(({ metrics }) => Object.keys(metrics)))];
  if (!names.length) return null;
  const rows = names.map((name) => {
    const row = h("tr", {}, h("th", { scope: "row", title: about.get(name) }, words(name)));
    for (const { head, metrics } of columns) {
      const found = metrics[name];
      row.append(h("td", { "data-label": head }, found ? number(found.value, found.unit) : "\u2013"));
    }
    return row;
  });
  return table(caption, ["number", ...columns.map(({ head }) => head)], rows, "numbers");
}

function tables(item: Case, report: Report): (HTMLElement | null)[] {
  const runs = item.entries.map(({ engine, run, timing }) => {
    const cost: Record<string, Measured> = timing
      ? {
          "time per step, median": { value: timing.step_us, unit: "\u00b5s" },
          "real-time factor": { value: timing.real_time_factor, unit: "" },
        }
      : {};
    return { head: engine.label, metrics: { ...run.metrics, ...cost } };
  });
  const pairs = item.comparisons.map(({ a, b, metrics }) => ({ head: `${a} vs ${b}`, metrics }));
  const about = new Map(report.metrics.map(({ name, definition }) => [name, definition]));
  return [metric_table("Metrics of each run", runs, about), metric_table("Differences", pairs, about)];
}

function numbers(item: Case, report: Report): HTMLElement {
  return folded("All numbers, and the command that repeats them", () => [
    ...tables(item, report),
    ...item.comparisons.filter(({ reason }) => reason).map(({ a, b, reason }) => h("p", {}, `${a} vs ${b}: ${reason}`)),
    command(case_command(report, item.scenario, item.variant)),
  ]);
}

function parameters(item: Case, chapter: Chapter): HTMLElement {
  const about = new Map(chapter.note?.parameters.map((parameter) => [parameter.name, parameter]));
  const items = Object.entries(item.parameters).map(([name, value]) => {
    const known = about.get(name);
    return h("div", known ? { title: known.about } : {}, h("dt", {}, words(name)), h("dd", {}, given(value, known?.unit)));
  });
  return h("dl", { class: "parameters" }, ...items);
}

/** All of a case but its name and verdicts. */
function details(item: Case, chapter: Chapter, { page }: Model): (HTMLElement | null)[] {
  let damage: HTMLElement | null = null;
  try {
    load_series(item);
  } catch (error) {
    damage = h("p", { role: "alert" }, `The charts of this case cannot be shown: ${(error as Error).message}`);
  }
  const ends = item.entries.flatMap(({ series }) => series?.t[series.t.length - 1] ?? []);
  const cursor = new Cursor(Math.max(0, ...ends));
  const drawn = item.entries.filter(({ series }) => series).map(({ engine }) => engine);
  return [
    parameters(item, chapter),
    verdict_list(item, page.report.engines),
    horizon(item),
    drawn.length ? legend(drawn) : null,
    damage,
    replay_figure(item, cursor),
    h("div", { class: "charts" }, ...case_charts(item, cursor)),
    checks(item),
    invariants(item),
    numbers(item, page.report),
  ];
}

/** The verdicts of the engines, each once, with how many have it. */
function verdicts_of(cases: Case[]): HTMLElement {
  const counts = new Map<Verdict, number>();
  for (const { engine, run } of cases.flatMap(({ entries }) => entries)) if (!engine.exact) counts.set(run.verdict, 1 + (counts.get(run.verdict) ?? 0));
  return h("span", { class: "tally" }, ...[...counts].map(([verdict, many]) => h("span", {}, badge(verdict), ` ${many}`)));
}

/** A case; with `fold`, only its name and verdicts until it is opened. */
function section(item: Case, chapter: Chapter, model: Model, fold: boolean): HTMLElement {
  const id = slug(item.scenario, item.variant);
  if (!fold) return h("article", { id, class: "case" }, h("h3", {}, item.variant), ...details(item, chapter, model));
  const title = [h("h3", {}, item.variant), verdicts_of([item])];
  const whole = folded(title, () => details(item, chapter, model), { holds: id });
  whole.classList.add("whole");
  return h("article", { id, class: "case" }, whole);
}

/** A scenario; with `fold`, its cases are made when they are opened: a long report opens at once and stays short. */
export function chapter_section(chapter: Chapter, model: Model, fold: boolean): HTMLElement {
  const id = slug(chapter.name);
  const question = chapter.note ? h("p", { class: "lede" }, chapter.note.question) : null;
  const cases = () => chapter.cases.map((item) => section(item, chapter, model, fold));
  if (!fold) return h("section", { id, class: "chapter" }, h("h2", {}, chapter.name), question, ...cases());
  const title = [h("h2", {}, chapter.name), h("span", { class: "basis" }, `${count(chapter.cases.length, "case")}; runs:`), verdicts_of(chapter.cases)];
  const whole = folded(title, () => [question, ...cases()], { holds: id });
  whole.classList.add("whole");
  return h("section", { id, class: "chapter short" }, whole);
}
