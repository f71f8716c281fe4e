// Small pieces that several sections use.
import type { Verdict } from "../data";
import { h } from "../dom";
import { share } from "../format";
import { verdict_signs, verdict_words } from "../verdict";

export function badge(verdict: Verdict): HTMLElement {
  return h(
    "span",
    { class: "badge", "data-verdict": verdict },
    h("span", { class: "sign", "aria-hidden": "true" }, verdict_signs[verdict]),
    verdict_words[verdict],
  );
}

/** An error as a bar; the tick is the limit, at two thirds of the width. */
export function gauge(ratio: number): HTMLElement {
  const width = Number.isFinite(ratio) ? Math.min(1.5, ratio) / 1.5 : 1;
  const bar = h("i", { style: `width: ${(100 * width).toFixed(1)}%` });
  return h("span", { class: ratio > 1 ? "gauge over" : "gauge", role: "img", "aria-label": `${share(ratio)} of what is allowed` }, bar);
}
