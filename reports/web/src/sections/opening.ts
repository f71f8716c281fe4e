// The head of the report: the result in one sentence, and what was compared.
import type { Run } from "../data";
import { h } from "../dom";
import { count, enumerate, time_step, times } from "../format";
import type { Engine, Entry, Model } from "../model";
import { mark } from "../pieces";

interface Tally {
  engine: Engine;
  judged: number;
  right: number;
}

const is_judged = (run: Run): boolean => run.verdict === "right" || run.verdict === "wrong" || run.verdict === "failed";

function tally(engine: Engine, entries: Entry[]): Tally {
  const judged = entries.filter((entry) => entry.engine === engine && is_judged(entry.run));
  return { engine, judged: judged.length, right: judged.filter(({ run }) => run.verdict === "right").length };
}

/** "impulse is right in all 9 cases, box2d in 7 of 9 and chipmunk in 8 of 9" */
function scores(tallies: Tally[]): string {
  const cases = Math.max(...tallies.map(({ judged }) => judged));
  const faultless = tallies.filter(({ right }) => right === cases);
  const others = tallies.filter((one) => !faultless.includes(one));
  const all = cases === 1 ? "the one case" : `all ${cases} cases`;
  const names = enumerate(faultless.map(({ engine }) => engine.label));
  const lead = faultless.length ? [`${names} ${faultless.length > 1 ? "are" : "is"} right in ${all}`] : [];
  const rest = others.map(({ engine, right, judged }, index) =>
    lead.length || index ? `${engine.label} in ${right} of ${judged}` : `${engine.label} is right in ${right} of ${count(judged, "case")}`,
  );
  return [...lead, ...(rest.length ? [enumerate(rest)] : [])].join(", ");
}

/** "; box2d has the largest error, in bounce (e=0.9): 3.2 times the tolerance" */
function largest_error(entries: Entry[]): string {
  const [largest] = entries
    .filter(({ engine, run, worst }) => !engine.exact && run.status === "ok" && worst > 1 && Number.isFinite(worst))
    .sort((a, b) => b.worst - a.worst);
  if (!largest) return "";
  const { engine, run, worst } = largest;
  return `; ${engine.label} has the largest error, in ${run.scenario} (${run.variant}): ${times(worst)} the tolerance`;
}

export function sentence(model: Model): string {
  const entries = model.chapters.flatMap((chapter) => chapter.cases.flatMap((item) => item.entries));
  const tallies = model.engines
    .filter((engine) => !engine.exact)
    .map((engine) => tally(engine, entries))
    .filter(({ judged }) => judged > 0);
  return tallies.length ? `${scores(tallies)}${largest_error(entries)}.` : "No case here has a truth to compare with.";
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
