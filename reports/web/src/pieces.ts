// Parts that several sections share: verdicts, gauges, command lines with a copy button, the logo, and the page that
// is shown if the data cannot be read.
import type { Report, Verdict } from "./data";
import { h, svg } from "./dom";
import { count, ratio_text, shell } from "./format";

/** Distinguishes verdicts without colour. */
const verdict_signs: Record<Verdict, string> = {
  right: "\u2713",
  coarse: "\u2213",
  wrong: "\u2717",
  plausible: "\u2248",
  "no evidence": "?",
  "beyond horizon": "\u223f",
  "not supported": "\u2013",
  failed: "!",
};

export function badge(verdict: Verdict): HTMLElement {
  return h(
    "span",
    { class: "badge", "data-verdict": verdict },
    h("span", { class: "sign", "aria-hidden": "true" }, verdict_signs[verdict]),
    verdict,
  );
}

/** What each verdict says, as in README.md and reports/glossary.md. */
export const verdict_meanings: Record<Verdict, string> = {
  right: "within 1 % of scale, explained by the method, and checked by what could have failed",
  coarse: "explained by the method, but farther off than 1 % of scale; a smaller step cures it",
  wrong: "farther off than the method explains, or an invariant is broken",
  plausible: "there is no truth to compare with; invariants that could have been broken held",
  "no evidence": "nothing that was checked could have failed: every tolerance is too large for a test",
  "beyond horizon": "past the time up to which the motion can be predicted; not compared point by point",
  "not supported": "the engine cannot run the scene, with the reason",
  failed: "the run diverged, crashed or stopped early, with the reason",
};

/** The verdicts that were given, each with its meaning. */
export function verdict_legend(given: Verdict[]): HTMLElement {
  const all = (Object.keys(verdict_meanings) as Verdict[]).filter((verdict) => given.includes(verdict));
  return h("ul", { class: "meanings" }, ...all.map((verdict) => h("li", {}, badge(verdict), h("span", {}, verdict_meanings[verdict]))));
}

/** A check is right only within this share of its scale. */
export const right_share = 0.01;

const ruler_decades = 4;

/** A share of a scale as a logarithmic bar from 0.01 % to 100 %, with a tick at 1 %. */
export function ruler(ratio: number | null): HTMLElement {
  const size = ratio ?? Infinity;
  const width = Math.min(1, Math.max(0, 1 + Math.log10(size) / ruler_decades));
  const bar = h("i", { style: `width: ${(100 * width).toFixed(1)}%` });
  return h("span", { class: size > right_share ? "ruler far" : "ruler", "aria-hidden": "true" }, bar);
}

/** error / tolerance as a bar; the tick at two thirds of the width is 1. */
export function gauge(ratio: number): HTMLElement {
  const width = Number.isFinite(ratio) ? Math.min(1.5, ratio) / 1.5 : 1;
  const bar = h("i", { style: `width: ${(100 * width).toFixed(1)}%` });
  return h("span", { class: ratio > 1 ? "gauge over" : "gauge", role: "img", "aria-label": `error / tolerance ${ratio_text(ratio)}` }, bar);
}

/** Uses the clipboard API, or the older command where the browser denies it to local files. */
export async function copy(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = h("textarea", { class: "unseen", "aria-hidden": "true" }, text);
    document.body.append(area);
    area.select();
    const copied = document.execCommand("copy");
    area.remove();
    return copied;
  }
}

export function copy_button(line: string): HTMLElement {
  const button = h("button", { type: "button", class: "copy", "aria-label": `Copy ${line}` }, "Copy");
  button.addEventListener("click", () => {
    void copy(line).then((copied) => {
      button.textContent = copied ? "Copied" : "Copy failed: select the line";
    });
  });
  return h("span", { role: "status" }, button);
}

export function command(line: string): HTMLElement {
  return h("div", { class: "command" }, h("code", {}, line), copy_button(line));
}

/** The variant of a scene file is its path. */
const is_file = (variant: string): boolean => variant.endsWith(".json") || variant.includes("/");

const case_word = (scenario: string, variant: string): string => (is_file(variant) ? variant : variant ? `${scenario}:${variant}` : scenario);

/** Options of the report's command that choose or judge runs, and how many values each takes. */
const kept: Record<string, number> = { "--converged": 0, "--no-converged": 0, "--ensemble": 1, "--engine": 1, "--dt": 1 };

/** The command that repeats one case. */
export function case_command({ command }: Report, scenario: string, variant: string): string {
  const options = command.flatMap((word, index) => (word in kept ? command.slice(index, index + 1 + (kept[word] ?? 0)) : []));
  return shell(["./plumb", "run", case_word(scenario, variant), ...options]);
}

export interface OneRun {
  scenario: string;
  variant: string;
  engine: string; // as --engine takes it
  setting: string; // key=value, or ""
  dt: string; // as --dt takes it
  converged?: boolean;
}

export function run_command({ scenario, variant, engine, setting, dt, converged = false }: OneRun): string {
  const configuration = setting ? `${engine}${engine.includes(":") ? "," : ":"}${setting}` : engine;
  const options = converged ? ["--converged"] : [];
  return shell(["./plumb", "run", case_word(scenario, variant), "--engine", configuration, "--dt", dt, ...options]);
}

const most_shown = 20;

/** Shown in place of a page that would be wrong. */
export function problems(found: string[]): HTMLElement {
  const more = found.length - most_shown;
  return h(
    "main",
    { class: "problems" },
    h("h1", {}, "This report cannot be read"),
    h("p", {}, "It is damaged, or another version of Plumb wrote it. Create it again with ", h("code", {}, "./plumb report"), "."),
    h("ul", {}, ...found.slice(0, most_shown).map((problem) => h("li", {}, problem))),
    more > 0 ? h("p", {}, `and ${count(more, "more problem")}`) : null,
  );
}

/** The logo: a plumb line. */
export function mark(): SVGElement {
  return svg(
    "svg",
    { viewBox: "0 0 24 72", width: 24, height: 72, class: "bob", "aria-hidden": "true" },
    svg("path", { d: "M12 0V40", class: "thread" }),
    svg("path", { d: "M12 40c4 0 7 3 7 8 0 7-4 14-7 22-3-8-7-15-7-22 0-5 3-8 7-8z", class: "weight" }),
  );
}
