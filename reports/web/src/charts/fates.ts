// How outcomes of the stability study look: colours after Okabe and Ito, told apart by the colour-blind, and a letter.
import { h } from "../dom";
import type { Outcome } from "../studies/stability_model";

interface Look {
  fill: string;
  ink: string; // of the letter on it
}

const dark = "#16181b";

const looks: Record<string, Look> = {
  h: { fill: "var(--right-wash)", ink: "var(--right)" },
  d: { fill: "#56b4e9", ink: dark },
  j: { fill: "#f0e442", ink: dark },
  s: { fill: "#3f8fc9", ink: dark },
  t: { fill: "#cc79a7", ink: dark },
  o: { fill: "#e69f00", ink: dark },
  g: { fill: "#e2703a", ink: dark },
  x: { fill: "var(--ink)", ink: "var(--paper)" },
  e: { fill: "var(--soft)", ink: "var(--paper)" },
};

const nothing: Look = { fill: "var(--quiet-wash)", ink: "var(--faint)" };

export const fate_look = ({ letter }: Outcome): Look => looks[letter] ?? nothing;

/** What is drawn in a cell: cells that hold stay calm. */
export const fate_letter = ({ letter }: Outcome): string => (letter === "h" ? "" : letter === "-" ? "\u2013" : letter);

export function fate_legend(outcomes: Outcome[]): HTMLElement {
  const swatch = (outcome: Outcome) => {
    const { fill, ink } = fate_look(outcome);
    return h("i", { class: "fate", style: `background: ${fill}; color: ${ink}`, "aria-hidden": "true" }, fate_letter(outcome));
  };
  return h("ul", { class: "legend fates" }, ...outcomes.map((outcome) => h("li", { title: outcome.about }, swatch(outcome), outcome.name)));
}
