// The report in one sentence, and the words for verdicts.
import type { Run, Verdict } from "./data";
import { count, enumerate, times } from "./format";
import type { Engine, Entry, Model } from "./model";

export const verdict_words: Record<Verdict, string> = {
  right: "right",
  plausible: "plausible",
  wrong: "wrong",
  "beyond horizon": "beyond horizon",
  "not supported": "not supported",
  failed: "failed",
};

/** Told apart without colour. */
export const verdict_signs: Record<Verdict, string> = {
  right: "\u2713",
  plausible: "\u2248",
  wrong: "\u2717",
  "beyond horizon": "\u223f",
  "not supported": "\u2013",
  failed: "!",
};

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

/** "; box2d is furthest off, in bounce (e=0.9): 3.2 times what is allowed" */
function furthest_off(entries: Entry[]): string {
  const [furthest] = entries
    .filter(({ engine, run, worst }) => !engine.exact && run.status === "ok" && worst > 1 && Number.isFinite(worst))
    .sort((a, b) => b.worst - a.worst);
  if (!furthest) return "";
  const { engine, run, worst } = furthest;
  return `; ${engine.label} is furthest off, in ${run.scenario} (${run.variant}): ${times(worst)} what is allowed`;
}

export function sentence(model: Model): string {
  const entries = model.chapters.flatMap((chapter) => chapter.cases.flatMap((place) => place.entries));
  const tallies = model.engines
    .filter((engine) => !engine.exact)
    .map((engine) => tally(engine, entries))
    .filter(({ judged }) => judged > 0);
  return tallies.length ? `${scores(tallies)}${furthest_off(entries)}.` : "Nothing here has a truth to be judged by.";
}
