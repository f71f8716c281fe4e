// What each engine's verdict in a case rests on, in a line: where it is furthest from what is allowed, or why it is not
// judged. The overview leads here.
import { h, slug } from "../dom";
import { given, number, share, times, words } from "../format";
import { law_ratio, ratio, type Case, type Entry } from "../model";
import { evidence as told } from "./invariants";
import { badge } from "./pieces";

interface Miss {
  ratio: number;
  words: string;
}

function misses({ run }: Entry): Miss[] {
  const readings = run.truth
    .filter(({ reported }) => reported)
    .map((check) => ({
      ratio: ratio(check),
      words: `${check.body ? `${check.body}, ` : ""}${words(check.quantity)} at ${given(check.time, "s", 4)}: off by ${number(check.error, check.unit, 2)}, allowed ${number(check.tolerance, check.unit, 2)}`,
    }));
  const laws = run.invariants
    .filter(({ status }) => status !== "not reported")
    .map((check) => ({ ratio: law_ratio(check), words: `${words(check.name)}: ${told(check)}` }));
  return [...readings, ...laws];
}

function reason(entry: Entry): string {
  const { run } = entry;
  if (run.status !== "ok") return run.reason;
  const [most] = misses(entry).sort((a, b) => b.ratio - a.ratio);
  if (!most) return "Nothing here is known to judge it by.";
  if (most.ratio === 0) return "No miss at all, of the truth or of what holds in any case.";
  return `Largest miss: ${most.words} (${most.ratio > 1 ? `${times(most.ratio)} that` : `${share(most.ratio)} of that`}).`;
}

export function evidence(place: Case): HTMLElement | null {
  const engines = place.entries.filter(({ engine }) => !engine.exact);
  if (!engines.length) return null;
  const items = engines.map((entry) => {
    const { label } = entry.engine;
    const id = slug(place.scenario, place.variant, label);
    return h("li", { id, "data-asks": label }, badge(entry.run.verdict), h("span", {}, h("strong", {}, label), ` ${reason(entry)}`));
  });
  return h("ul", { class: "evidence" }, ...items);
}
