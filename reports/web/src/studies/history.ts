// The history of reports from commit to commit: a list of changes, and charts of what changed.
import { figure } from "../charts/figure";
import { legend } from "../charts/look";
import type { Study } from "../data";
import { h, slug, table } from "../dom";
import { folded } from "../folded";
import { count, enumerate, number, time_step } from "../format";
import { look_of } from "../looks";
import type { Engine, StudyView } from "../model";
import { day, history_of, metric_name, panels_of, short_commit, step_time, type HistoryModel, type Panel } from "./history_model";
import { certainty, trend_chart } from "./trend";

const most_rows = 200;

interface Row {
  snapshot: number;
  size: number; // relative; the largest come first
  what: string;
  who: string;
  metric: string;
  before: string;
  after: string;
  by: string;
  certainty: string;
}

const case_name = ({ scenario, variant }: { scenario: string; variant: string }): string => (variant ? `${scenario}, ${variant}` : scenario);
const percent = (before: number, after: number): string => {
  if (before === 0) return "from 0";
  const share = (100 * (after - before)) / Math.abs(before);
  return `${share > 0 ? "+" : ""}${number(share, "%", 2)}`;
};

/** The newest snapshot first; the largest change of each snapshot first. */
function rows_of({ trends, verdicts }: HistoryModel): Row[] {
  const of_verdicts = verdicts.map(
    ({ snapshot, before, after, engine, ...subject }): Row => ({ snapshot, size: Infinity, what: case_name(subject), who: engine, metric: "verdict", before, after, by: "", certainty: "exact" }),
  );
  const of_trends = trends.flatMap((trend) =>
    trend.changes.map(({ at, before, after, p }): Row => {
      const least = Math.min(Math.abs(before), Math.abs(after));
      return {
        snapshot: trend.snapshots[at] ?? 0,
        size: least === 0 ? Number.MAX_VALUE : Math.abs(after - before) / least,
        what: case_name(trend),
        who: trend.engine,
        metric: metric_name(trend.metric),
        before: number(before, trend.unit, 4),
        after: number(after, trend.unit, 4),
        by: percent(before, after),
        certainty: certainty(p),
      };
    }),
  );
  return [...of_verdicts, ...of_trends].sort((a, b) => b.snapshot - a.snapshot || (a.size === b.size ? 0 : b.size - a.size));
}

function changes(model: HistoryModel, rows: Row[]): HTMLElement {
  const times = model.trends.filter(({ metric }) => metric === step_time).length;
  const cells = rows.slice(0, most_rows).map((row) => {
    const snapshot = model.snapshots[row.snapshot];
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, snapshot ? `${day(snapshot)} ${short_commit(snapshot)}` : ""),
      h("td", { "data-label": "case" }, row.what),
      h("td", { "data-label": "engine" }, row.who),
      h("td", { "data-label": "metric" }, row.metric),
      h("td", { "data-label": "before" }, row.before),
      h("td", { "data-label": "after" }, row.after),
      h("td", { "data-label": "by" }, row.by),
      h("td", { "data-label": "certainty" }, row.certainty),
    );
  });
  const rest = rows.length > most_rows ? ` The newest ${most_rows} of ${rows.length} are shown.` : "";
  return h(
    "section",
    { id: "changes" },
    h("h2", {}, "What changed"),
    h(
      "p",
      { class: "lede" },
      `All numbers but times are exact: any difference is a change. Times scatter: a change is reported if fewer than ${number(100 * model.level, "%", 1)} of random permutations of the same values show it (E-divisive), so about ${number(times * model.level, "", 1)} of the ${times} series of times look changed by chance. ${count(model.unchanged, "other number")} never changed.${rest}`,
    ),
    rows.length
      ? table("Changes, the newest first", ["since", "case", "engine", "metric", "before", "after", "by", "certainty"], cells)
      : h("p", { class: "absence" }, "Nothing changed."),
  );
}

/** A single machine is described at the end of the page instead. */
const machines_of = ({ trends }: HistoryModel): number => new Set(trends.flatMap(({ machine }) => machine || [])).size;

function chart_of(panel: Panel, model: HistoryModel, engine_of: (label: string) => Engine): HTMLElement {
  return figure({
    title: `${panel.variant || panel.scenario}: ${metric_name(panel.metric)}`,
    note: [`Time step ${time_step(panel.dt)}.`, machines_of(model) > 1 ? panel.machine : ""].filter(Boolean).join(" "),
    height: 240,
    draw: (width) => [trend_chart(width, panel, model.snapshots, engine_of)],
  });
}

function trend_section(scenario: string, panels: Panel[], model: HistoryModel, engine_of: (label: string) => Engine): HTMLElement {
  const moving = panels.filter(({ trends }) => trends.some((trend) => trend.changes.length));
  const steady = panels.filter((panel) => !moving.includes(panel));
  const shown = [...new Set(panels.flatMap(({ trends }) => trends.map(({ engine }) => engine)))].map(engine_of);
  const charts = (some: Panel[]) => h("div", { class: "charts" }, ...some.map((panel) => chart_of(panel, model, engine_of)));
  return h(
    "section",
    { id: slug("trend", scenario), class: "chapter" },
    h("h2", {}, scenario),
    legend(shown),
    moving.length ? charts(moving) : h("p", { class: "absence" }, "Nothing changed here."),
    steady.length ? folded("Times without a change", () => [charts(steady)]) : null,
  );
}

function sentence(model: HistoryModel, rows: Row[]): string {
  const [first, last] = [model.snapshots[0], model.snapshots[model.snapshots.length - 1]];
  if (!first || !last) return "Nothing has been recorded.";
  const verdicts = model.verdicts.length;
  const numbers = rows.length - verdicts;
  const newest = rows.filter(({ snapshot }) => snapshot === model.snapshots.length - 1).length;
  const found = [verdicts ? count(verdicts, "verdict") : "", numbers ? count(numbers, "number") : ""].filter(Boolean);
  return `From ${day(first)} to ${day(last)}, over ${count(model.snapshots.length, "snapshot")}: ${found.length ? `${enumerate(found)} changed, ${newest || "none"} in the newest` : "nothing changed"}.`;
}

export function history(study: Study): StudyView {
  const model = history_of(study);
  const rows = rows_of(model);
  const labels = [...new Set(model.trends.map(({ engine }) => engine))];
  const engines = new Map(labels.map((label): [string, Engine] => [label, { label, engine: label, method: "", exact: false, execution: "", ...look_of(label) }]));
  const engine_of = (label: string): Engine => engines.get(label) ?? { label, engine: label, method: "", exact: false, execution: "", ...look_of(label) };
  const panels = panels_of(model.trends);
  const scenarios = [...new Set(panels.map(({ scenario }) => scenario))];
  return {
    sentence: sentence(model, rows),
    sections: [
      { id: "changes", name: "What changed", content: () => changes(model, rows) },
      ...scenarios.map((scenario) => ({
        id: slug("trend", scenario),
        name: scenario,
        content: () => trend_section(scenario, panels.filter((panel) => panel.scenario === scenario), model, engine_of),
      })),
    ],
  };
}
