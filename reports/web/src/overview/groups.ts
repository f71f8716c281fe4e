// The groups of scenarios by what they ask: what is at stake, and in how many cases each engine is wrong.
import { h, table } from "../dom";
import type { Chapter, Engine, Model } from "../model";

/** Null for a report without groups, or with one alone. */
export function groups(model: Model, engines: Engine[]): HTMLElement | null {
  const notes = (model.page.report.groups ?? []).map((note) => ({ note, chapters: model.chapters.filter((chapter) => chapter.note?.group === note.name) }));
  const shown = notes.filter(({ chapters }) => chapters.length);
  if (shown.length < 2) return null;
  const heads = ["group", "at stake", "scenarios", ...engines.map(({ label }) => label)];
  const rows = shown.map(({ note, chapters }) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, note.title),
      h("td", { "data-label": heads[1], class: "stake" }, note.stake),
      h("td", { "data-label": heads[2] }, String(chapters.length)),
      ...engines.map((engine) => h("td", { "data-label": engine.label }, wrong(chapters, engine))),
    ),
  );
  return h(
    "div",
    { class: "groups" },
    h("h3", {}, "What is at stake"),
    h("p", { class: "lede" }, "Scenarios by what they ask, what goes wrong in a game or a simulation where an engine fails, and in how many cases each engine is wrong."),
    table("Wrong cases by group", heads, rows),
  );
}

function wrong(chapters: Chapter[], engine: Engine): string {
  const verdicts = chapters.flatMap(({ cases }) => cases.flatMap(({ entries }) => entries.filter((one) => one.engine === engine).map(({ run }) => run.verdict)));
  const judged = verdicts.filter((verdict) => verdict !== "not supported");
  const bad = judged.filter((verdict) => verdict === "wrong" || verdict === "failed").length;
  return judged.length ? `${bad} of ${judged.length}` : "\u2013";
}
