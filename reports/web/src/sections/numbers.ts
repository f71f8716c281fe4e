// Two tables of a case: what was measured of each run, and how far the runs are from each other and from the truth.
import type { Measured, Report } from "../data";
import { h, table } from "../dom";
import { folded } from "../folded";
import { number, words } from "../format";
import type { Case } from "../model";
import { case_command, command } from "./command";

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

function tables(place: Case, report: Report): (HTMLElement | null)[] {
  const runs = place.entries.map(({ engine, run, timing }) => {
    const cost: Record<string, Measured> = timing
      ? {
          "time per step, median": { value: timing.step_us, unit: "\u00b5s" },
          "real-time factor": { value: timing.real_time_factor, unit: "" },
        }
      : {};
    return { head: engine.label, metrics: { ...run.metrics, ...cost } };
  });
  const pairs = place.comparisons.map(({ a, b, metrics }) => ({ head: `${a} against ${b}`, metrics }));
  const about = new Map(report.metrics.map(({ name, definition }) => [name, definition]));
  return [metric_table("Measured of each run", runs, about), metric_table("Differences", pairs, about)];
}

export function numbers(place: Case, report: Report): HTMLElement {
  return folded("All numbers, and how to make them again", () => [
    ...tables(place, report),
    ...place.comparisons.filter(({ reason }) => reason).map(({ a, b, reason }) => h("p", {}, `${a} against ${b}: ${reason}`)),
    command(case_command(report, place.scenario, place.variant)),
  ]);
}
