// The head of the report: the result in one sentence, and what was compared.
import { h } from "../dom";
import { count, enumerate, share, time_step } from "../format";
import { relative_of, reported, type Engine, type Entry, type Model } from "../model";
import { mark, right_share } from "../pieces";

interface Tally {
  engine: Engine;
  cases: number;
  wrong: number;
  checks: number;
  near: number; // checks within 1 % of scale
}

function tally(engine: Engine, entries: Entry[]): Tally {
  const runs = entries.filter((entry) => entry.engine === engine && entry.run.status !== "not supported").map(({ run }) => run);
  const checks = runs.flatMap(reported);
  return {
    engine,
    cases: runs.length,
    wrong: runs.filter(({ verdict }) => verdict === "wrong" || verdict === "failed").length,
    checks: checks.length,
    near: checks.filter((check) => relative_of(check) <= right_share).length,
  };
}

/**
 * "Within 1 % of scale: impulse in 97 % of its checks, box2d in 72 %. Wrong beyond what their methods explain: impulse in 1
 * of 99 cases, box2d in 16."
 */
export function sentence(model: Model): string {
  const entries = model.chapters.flatMap((chapter) => chapter.cases.flatMap((item) => item.entries));
  const tallies = model.engines
    .filter((engine) => !engine.exact)
    .map((engine) => tally(engine, entries))
    .filter(({ checks }) => checks > 0);
  if (!tallies.length) return "No case here has a truth to compare with.";
  const near = tallies.map(({ engine, near, checks }, index) => `${engine.label} in ${share(near, checks)}${index ? "" : " of its checks"}`);
  const wrong = tallies.map(({ engine, wrong, cases }, index) => `${engine.label} in ${wrong}${index ? "" : ` of ${count(cases, "case")}`}`);
  const verdict = tallies.every((one) => one.wrong === 0)
    ? "None is wrong beyond what its method explains."
    : `Wrong beyond what the method explains: ${enumerate(wrong)}.`;
  return `Within 1 % of scale: ${enumerate(near)}. ${verdict}`;
}

export function opening(model: Model): HTMLElement {
  const { report } = model.page;
  const cases = model.chapters.reduce((sum, chapter) => sum + chapter.cases.length, 0);
  const engines = model.engines.filter(({ exact }) => !exact).map(({ label }) => label);
  const steps = [...new Set(report.runs.filter(({ exact, dt }) => !exact && dt > 0).map(({ dt }) => time_step(dt)))];
  const basis = [
    `${count(model.chapters.length, "scenario")} in ${count(cases, "case")}`,
    engines.length ? enumerate(engines) : "",
    model.engines.some(({ exact }) => exact) ? "the closed form as the truth" : "",
    steps.length ? `time step ${enumerate(steps)}` : "",
  ];
  return h(
    "header",
    { class: "opening" },
    mark(),
    h(
      "div",
      {},
      h("p", { class: "title" }, report.title || "Plumb report"),
      h("h1", {}, sentence(model)),
      h("p", { class: "basis" }, basis.filter(Boolean).join(" \u00b7 ")),
    ),
  );
}
