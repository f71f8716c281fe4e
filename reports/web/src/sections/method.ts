// How the numbers are made, on what, and how to make them again.
import type { EngineNote } from "../data";
import { h } from "../dom";
import { folded } from "../folded";
import { number, pretty_unit, shell, words } from "../format";
import type { Model } from "../model";
import { case_command, command } from "../pieces";

const definitions: [string, string][] = [
  ["right", "every reading is within what is allowed of the truth, and no invariant is broken"],
  ["plausible", "there is no truth to judge by, and no invariant is broken: engines may differ and all be plausible"],
  ["wrong", "wrong physics: a reading is off, or an invariant broken, by more than the order of the method predicts"],
  ["beyond horizon", "past the time for which motions can be predicted; not judged point by point"],
  ["not supported", "the engine cannot be asked this; the reason stands beside it"],
  ["failed", "the run diverged or broke off; the reason stands beside it"],
  [
    "tolerance",
    "how far off a correct engine may be: from the order of its method, its step, the gaps it states and the round-off of its arithmetic. No limit is set by what an engine happened to do.",
  ],
  ["energy", "kinetic, rotational and gravitational, of all dynamic bodies, from the scene and the read-out states; no engine is asked"],
  ["momentum", "linear, and angular about the world\u2019s origin, of all dynamic bodies"],
  ["share of allowed", "a miss divided by what is allowed there: up to 1 is right. A run is judged by its largest"],
  ["distance from the truth", "of the bodies\u2019 centres, root mean square over bodies and recorded moments"],
  ["time per step", "only the engine\u2019s own step is timed, after a warm-up, the engines taking turns; median over the repetitions, with the lower and the upper quartile. Reading, judging and writing are never on the clock"],
  ["real-time factor", "simulated seconds for each second spent in steps"],
];

function entries(pairs: [string, string][], kind: string): HTMLElement {
  return h("dl", { class: kind }, ...pairs.map(([name, value]) => h("div", {}, h("dt", {}, name), h("dd", {}, value))));
}

const described = (notes: EngineNote[]): [string, string][] =>
  notes.map(({ name, about, source }) => [name, source ? `${about}. ${source}` : about]);

/** "runs_s" is in seconds; what names no unit is a share. */
const clock_entry = ([name, value]: [string, number | null]): [string, string] =>
  name.endsWith("_s")
    ? [words(name.slice(0, -2)), number(value, "s")]
    : [words(name), number(value === null ? null : 100 * value, "%")];

/** What was asked of an engine and not answered, by reason, with the cases. */
function unanswered({ chapters }: Model): Map<string, string[]> {
  const found = new Map<string, string[]>();
  const add = (reason: string, place: string) => found.set(reason, [...new Set([...(found.get(reason) ?? []), place])]);
  for (const { scenario, variant, entries } of chapters.flatMap(({ cases }) => cases)) {
    for (const { engine, run } of entries) {
      const place = `${scenario} (${variant})`;
      if (run.status === "not supported") add(`${engine.label}: ${run.reason}`, place);
      for (const check of run.truth) if (!check.reported) add(`${engine.label} does not report ${words(check.quantity)}`, place);
      for (const law of run.invariants) if (law.status === "not reported") add(`${engine.label} does not report what would tell of ${words(law.name)}`, place);
    }
  }
  return found;
}

function not_supported(model: Model): HTMLElement[] {
  const found = unanswered(model);
  if (!found.size) return [];
  const about = "What an engine cannot be asked, or does not show, is neither right nor wrong: it is left out, and said here.";
  const cases = [...found].map(([reason, places]): [string, string] => [reason, places.join(", ")]);
  return [h("h3", {}, "Not supported, or not reported"), h("p", { class: "lede" }, about), entries(cases, "definitions")];
}

/** The whole report, each of its cases, each study: as lines to copy. */
function again({ page, chapters }: Model): HTMLElement[] {
  const { report, studies } = page;
  const cases = chapters.flatMap(({ cases }) => cases).map(({ scenario, variant }) => case_command(report, scenario, variant));
  const whole = report.command.length ? [command(shell(["./plumb", ...report.command.slice(1)]))] : [];
  return [
    ...whole,
    ...studies.flatMap((study) => (study.command ? [command(`./${study.command}`)] : [])),
    folded("Each case alone", () => cases.map(command)),
  ];
}

export function method(model: Model): HTMLElement {
  const { report } = model.page;
  const clock = Object.entries(report.timings.clock).map(clock_entry);
  return h(
    "section",
    { id: "method" },
    h("h2", {}, "Method"),
    h("p", { class: "lede" }, "Every engine is given the same scene, steps it with the same time step, and is read the same way."),
    h("h3", {}, "Words"),
    entries(definitions, "definitions"),
    h("h3", {}, "Metrics"),
    entries(
      report.metrics.map(({ name, unit, definition }) => [`${words(name)}${unit ? ` (${pretty_unit(unit)})` : ""}`, definition]),
      "definitions",
    ),
    h("h3", {}, "What holds in any case"),
    entries(
      report.invariants.map(({ name, unit, definition }) => [`${words(name)} (${pretty_unit(unit)})`, definition]),
      "definitions",
    ),
    h("h3", {}, "Engines"),
    entries(described(report.engines.filter(({ exact }) => !exact)), "definitions"),
    h("h3", {}, "Truths"),
    entries(described(report.engines.filter(({ exact }) => exact)), "definitions"),
    ...not_supported(model),
    h("h3", {}, "To make it again"),
    ...again(model),
    h("h3", {}, "Made with"),
    entries(Object.entries(report.environment).map(([name, value]) => [words(name), value]), "environment"),
    clock.length ? h("h3", {}, "Time it took") : null,
    clock.length ? entries(clock, "environment") : null,
  );
}
