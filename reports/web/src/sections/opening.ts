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

/** "64 to 80", or "64" if all are the same */
function range(values: number[], shown: (value: number) => string): string {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  return low === high ? shown(low) : `${shown(low)} to ${shown(high)}`;
}

const near_share = ({ near, checks }: Tally): number => near / checks;

/**
 * "impulse is the closest to the truth: within 1 % of scale in 99 % of its checks, wrong in 2 of 136 cases. The other 3 are
 * within it in 64 to 80 %, wrong in 18 to 27 cases."
 */
export function sentence(model: Model): string {
  const entries = model.chapters.flatMap((chapter) => chapter.cases.flatMap((item) => item.entries));
  const tallies = model.engines
    .filter((engine) => !engine.exact)
    .map((engine) => tally(engine, entries))
    .filter(({ checks }) => checks > 0)
    .sort((a, b) => near_share(b) - near_share(a));
  const [best, ...others] = tallies;
  if (!best) return "No case here has a truth to compare with.";
  const wrong = best.wrong ? `wrong in ${best.wrong} of ${count(best.cases, "case")}` : `wrong in none of ${count(best.cases, "case")}`;
  const close = `within 1 % of scale in ${share(best.near, best.checks)} of its checks, ${wrong}`;
  const [other] = others;
  if (!other) return `${best.engine.label} is ${close}.`;
  const who = others.length === 1 ? `${other.engine.label} is` : `The other ${others.length} are`;
  const shares = range(others.map(({ near, checks }) => Math.floor((100 * near) / checks)), String);
  const wrongs = range(others.map((one) => one.wrong), String);
  const lead = near_share(best) > near_share(other) ? `${best.engine.label} is the closest to the truth: ` : `${best.engine.label} is `;
  return `${lead}${close}. ${who} within it in ${shares}\u202f%, wrong in ${wrongs}.`;
}

export function opening(model: Model): HTMLElement {
  const { report } = model.page;
  const cases = model.chapters.reduce((sum, chapter) => sum + chapter.cases.length, 0);
  const engines = model.engines.filter(({ exact }) => !exact).map(({ label }) => label);
  const steps = [...new Set(report.runs.filter(({ exact, dt }) => !exact && dt > 0).map(({ dt }) => dt))].map(time_step);
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
