// The changes since the accepted baseline, in the form of a study, for the runs that both have.
import type { Study } from "../data";
import { h, slug, table } from "../dom";
import { count, words } from "../format";
import { label_of, type StudyView } from "../model";
import { command } from "../pieces";

interface Regression {
  scenario: string;
  variant: string;
  engine: string;
  method: string;
  metric: string;
  before: string;
  now: string;
  tolerance: string;
  why: string;
  change: string; // "worse", "changed", "better"
}

interface Changes {
  verdict: string;
  notes: string[];
  runs: number; // in both
  regressions: Regression[]; // worst first
}

const most_shown = 100;
const heads = ["case", "engine", "what", "before", "now", "tolerance", "why"];

const changes_of = (study: Study): Changes => study.findings as unknown as Changes;

export const sentence = (study: Study): string => changes_of(study).verdict;

function row(one: Regression): HTMLTableRowElement {
  const cells = [label_of(one), words(one.metric), one.before, one.now, one.tolerance, one.why].map((text, index) =>
    h("td", { "data-label": heads[index + 1], ...(index === 5 ? { class: "reason" } : {}) }, text),
  );
  return h("tr", { "data-change": one.change }, h("th", { scope: "row" }, `${one.scenario}, ${one.variant}`), ...cells);
}

export function baseline(study: Study): StudyView {
  const { regressions, notes, runs } = changes_of(study);
  const more = regressions.length - most_shown;
  const about = `${study.about}: ${count(runs, "run")} that are also in ${String(study.configuration["baseline"])}. ${notes.join(" ")}`;
  const content = () => h(
    "div",
    { id: slug("changes") },
    h("p", { class: "lede" }, about),
    regressions.length ? table("What changed since the baseline", heads, regressions.slice(0, most_shown).map(row)) : null,
    more > 0 ? h("p", { class: "basis" }, `And ${count(more, "more change")}.`) : null,
    command("./plumb check"),
  );
  return { sentence: sentence(study), sections: [{ id: "changes", name: "Changes", content }] };
}
