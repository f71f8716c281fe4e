// The report in one sentence, and the words for verdicts.
import type { Run, Verdict } from "./data";
import { count, enumerate, times } from "./format";
import type { Contender, Entry, Model } from "./model";

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
  contender: Contender;
  judged: number;
  right: number;
}

const is_judged = (run: Run): boolean => run.verdict === "right" || run.verdict === "wrong" || run.verdict === "failed";

function tally(contender: Contender, entries: Entry[]): Tally {
  const judged = entries.filter((entry) => entry.contender === contender && is_judged(entry.run));
  return { contender, judged: judged.length, right: judged.filter(({ run }) => run.verdict === "right").length };
}

/** "impulse is right in all 9 cases, box2d in 7 of 9; box2d is furthest off, in bounce (e 0.9): 3.2 times what is allowed." */
export function sentence(model: Model): string {
  const entries = model.chapters.flatMap((chapter) => chapter.cases.flatMap((place) => place.entries));
  const tallies = model.contenders
    .filter((contender) => !contender.exact)
    .map((contender) => tally(contender, entries))
    .filter(({ judged }) => judged > 0);
  if (!tallies.length) return "Nothing here has a truth to be judged by.";

  const all_right = tallies.every(({ right, judged }) => right === judged);
  const cases = tallies[0]?.judged ?? 0;
  if (all_right && tallies.length > 1 && tallies.every(({ judged }) => judged === cases)) {
    const who = tallies.length === 2 ? enumerate(tallies.map(({ contender }) => contender.label)) : `All ${tallies.length} engines`;
    return `${who} are right in ${cases === 1 ? "the one case" : `all ${cases} cases`} that physics can judge.`;
  }
  const parts = tallies.map(({ contender, right, judged }, index) => {
    const of = index ? String(judged) : count(judged, "case");
    const how = right === judged ? `all ${of}` : `${right} of ${of}`;
    return `${contender.label}${index ? "" : " is right"} in ${how}`;
  });
  const furthest = entries
    .filter(({ contender, run }) => !contender.exact && run.verdict === "wrong" && run.status === "ok")
    .sort((a, b) => b.worst - a.worst)[0];
  const worst =
    furthest && furthest.worst > 1 && Number.isFinite(furthest.worst)
      ? `; ${furthest.contender.label} is furthest off, in ${furthest.run.scenario} (${furthest.run.variant}): ${times(furthest.worst)} what is allowed`
      : "";
  return `${enumerate(parts)}${worst}.`;
}
