// How far ahead a case can be told, and what is said of the engines beyond.
import { h } from "../dom";
import { given } from "../format";
import type { Case } from "../model";

export function horizon(place: Case): HTMLElement | null {
  if (place.horizon === undefined) return null;
  const compared = place.comparisons.filter(({ metrics }) => "horizon" in metrics);
  return h(
    "div",
    { class: "horizon" },
    h(
      "p",
      {},
      `This motion can be told for ${given(place.horizon, "s", 3)}: by then runs that began 1 nm apart have parted. `,
      "Beyond, many runs of each engine are compared as a whole.",
    ),
    h("ul", {}, ...compared.map(({ a, b, reason }) => h("li", {}, `${a} and ${b}: ${reason}`))),
  );
}
