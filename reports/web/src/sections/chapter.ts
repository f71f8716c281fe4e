// One scenario: its question, and for each case its charts, checks and numbers.
import { case_charts } from "../charts/case";
import { Cursor } from "../charts/cursor";
import { legend } from "../charts/look";
import type { Measured, Report } from "../data";
import { h, slug, table } from "../dom";
import { folded } from "../folded";
import { given, number, words } from "../format";
import type { Case, Chapter, Model } from "../model";
import { case_command, command } from "../pieces";
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

function section(item: Case, chapter: Chapter, { page }: Model): HTMLElement {
  const ends = item.entries.flatMap(({ series }) => series?.t[series.t.length - 1] ?? []);
  const cursor = new Cursor(Math.max(0, ...ends));
  const drawn = item.entries.filter(({ series }) => series).map(({ engine }) => engine);
  return h(
    "article",
    { id: slug(item.scenario, item.variant), class: "case" },
    h("h3", {}, item.variant),
    parameters(item, chapter),
    verdict_list(item),
    horizon(item),
    drawn.length ? legend(drawn) : null,
    replay_figure(item, cursor),
    h("div", { class: "charts" }, ...case_charts(item, cursor)),
    checks(item),
    invariants(item),
    numbers(item, page.report),
  );
}

export function chapter_section(chapter: Chapter, model: Model): HTMLElement {
  return h(
    "section",
    { id: slug(chapter.name), class: "chapter" },
    h("h2", {}, chapter.name),
    chapter.note ? h("p", { class: "lede" }, chapter.note.question) : null,
    ...chapter.cases.map((item) => section(item, chapter, model)),
  );
}
