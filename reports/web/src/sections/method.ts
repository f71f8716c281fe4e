// How the numbers are computed, what the words mean, and how to repeat the report.
import type { EngineNote } from "../data";
import { h } from "../dom";
import { folded } from "../folded";
import { number, pretty_unit, shell, words } from "../format";
import type { Model } from "../model";
import { case_command, command, verdict_meanings } from "../pieces";

/** As in README.md ("Reading a report"), plus the numbers that this page adds. */
const definitions: [string, string][] = [
  ...Object.entries(verdict_meanings),
  ["not reported", "the engine does not report what the check needs, such as contacts; counts neither way"],
  ["not applicable", "nothing in the run asks the question, such as a law of contacts where nothing touches; counts neither way"],
  ["error", "|measured \u2212 expected|, in the unit of the quantity"],
  [
    "scale",
    "what the truth says changes in the scene: a displacement, a speed, an energy that is exchanged, an angle; at least a floor such as the size of the body; from the scene alone, so the same ruler for every engine",
  ],
  ["error / scale", "how far off a run is; within 1 % may be right, farther off is coarse at best"],
  [
    "tolerance",
    "how far off a correct engine may be: derived from the order of its method, its step, the skin and slop that it states, and the round-off of its arithmetic, never from what an engine happened to do",
  ],
  ["error / tolerance", "whether the method explains the error: above 1 is wrong; the largest of a run decides"],
  ["not a test", "the tolerance is more than 5 % of scale, or nothing happened that the invariant could catch: the check could not have failed, and is no evidence"],
  ["at rest", "all bodies are slower than 1 cm/s and 0.01 rad/s from some time until the end"],
  ["energy", "kinetic, rotational and gravitational, of all dynamic bodies, computed from the scene and the positions and velocities read out, not by the engine"],
  ["momentum", "linear, and angular about the world\u2019s origin, of all dynamic bodies"],
  ["distance from the truth", "of the bodies\u2019 centres, root mean square over bodies and recorded moments"],
  ["time per step", "median over repetitions in which the engines take turns, with the quartiles; only the engine\u2019s step is timed, after a warm-up"],
  ["real-time factor", "simulated time per second spent in steps"],
];

/** The words of reports/glossary.md, by build.mjs. */
declare const PLUMB_GLOSSARY: [string, string][];

function entries(pairs: [string, string][], kind: string): HTMLElement {
  return h("dl", { class: kind }, ...pairs.map(([name, value]) => h("div", {}, h("dt", {}, name), h("dd", {}, value))));
}

const described = (notes: EngineNote[]): [string, string][] =>
  notes.map(({ name, about, source, word, language, execution, exact }) => {
    const code = exact ? "" : [language, execution].filter((part) => part).join(", ");
    return [name, [about, source, code, word ? `--engine ${shell([word])}` : ""].filter((part) => part).join(". ")];
  });

/** "runs_s" is in seconds; a name without a unit is a share. */
const clock_entry = ([name, value]: [string, number | null]): [string, string] =>
  name.endsWith("_s")
    ? [words(name.slice(0, -2)), number(value, "s")]
    : [words(name), number(value === null ? null : 100 * value, "%")];

/** The cases that an engine does not support or report, by reason. */
function missing({ chapters }: Model): Map<string, string[]> {
  const found = new Map<string, string[]>();
  const add = (reason: string, item: string) => found.set(reason, [...new Set([...(found.get(reason) ?? []), item])]);
  for (const { scenario, variant, entries } of chapters.flatMap(({ cases }) => cases)) {
    for (const { engine, run } of entries) {
      const item = `${scenario} (${variant})`;
      if (run.status === "not supported") add(`${engine.label}: ${run.reason}`, item);
      for (const check of run.truth) if (!check.reported) add(`${engine.label} does not report ${words(check.quantity)}`, item);
      for (const check of run.invariants) {
        if (check.status === "not reported") add(`${engine.label} does not report what the invariant ${words(check.name)} needs`, item);
      }
    }
  }
  return found;
}

function not_supported(model: Model): HTMLElement[] {
  const found = missing(model);
  if (!found.size) return [];
  const about = "Checks that need something an engine does not support or report count neither for nor against it.";
  const cases = [...found].map(([reason, items]): [string, string] => [reason, items.join(", ")]);
  return [folded("Not supported, or not reported", () => [h("p", { class: "lede" }, about), entries(cases, "definitions")])];
}

/** The commands of the whole report, of each study and of each case. */
function commands({ page, chapters }: Model): HTMLElement[] {
  const { report, studies } = page;
  const cases = chapters.flatMap(({ cases }) => cases).map(({ scenario, variant }) => case_command(report, scenario, variant));
  const whole = report.command.length ? [command(shell(["./plumb", ...report.command.slice(1)]))] : [];
  return [
    ...whole,
    ...studies.flatMap((study) => (study.command ? [command(`./${study.command}`)] : [])),
    folded("Each case by itself", () => cases.map(command)),
  ];
}

export function method(model: Model): HTMLElement {
  const { report } = model.page;
  const clock = Object.entries(report.timings.clock).map(clock_entry);
  return h(
    "section",
    { id: "method" },
    h("h2", {}, "Method"),
    h("p", { class: "lede" }, "Every engine gets the same scene, runs it with the same time step, and is measured in the same way."),
    h("h3", {}, "Words"),
    entries(definitions, "definitions"),
    folded("Glossary: all other words", () => [entries(PLUMB_GLOSSARY, "definitions")]),
    folded("Metrics", () => [
      entries(
        report.metrics.map(({ name, unit, definition }) => [`${words(name)}${unit ? ` (${pretty_unit(unit)})` : ""}`, definition]),
        "definitions",
      ),
    ]),
    folded("Invariants", () => [
      entries(
        report.invariants.map(({ name, unit, definition }) => [`${words(name)} (${pretty_unit(unit)})`, definition]),
        "definitions",
      ),
    ]),
    h("h3", {}, "Engines"),
    entries(described(report.engines.filter(({ exact }) => !exact)), "definitions"),
    folded("Closed forms", () => [entries(described(report.engines.filter(({ exact }) => exact)), "definitions")]),
    ...not_supported(model),
    h("h3", {}, "Repeat it"),
    ...commands(model),
    h("h3", {}, "Environment"),
    entries(Object.entries(report.environment).map(([name, value]) => [words(name), value]), "environment"),
    clock.length ? h("h3", {}, "Run time") : null,
    clock.length ? entries(clock, "environment") : null,
  );
}
