// Which engine keeps which metamorphic relation: the share of cases in which a scene and its image move alike, by the same
// ruler for every engine, and in how many they differ by more than can be explained.
import { h, table } from "../dom";
import { count, share, words } from "../format";
import type { Engine, Model } from "../model";

const prefix = "relation_";
const alike = 1e-4; // of how far a body moves, or its size

/** Null for a report that was made without relations. */
export function relations(model: Model, engines: Engine[]): HTMLElement | null {
  const entries = model.chapters.flatMap(({ cases }) => cases.flatMap((item) => item.entries));
  const checks = entries.flatMap(({ engine, run }) =>
    run.invariants.filter(({ name }) => name.startsWith(prefix)).map((check) => ({ engine, check, share: run.metrics[check.name]?.value ?? Infinity })),
  );
  const names = [...new Set(checks.map(({ check }) => check.name))].sort();
  if (!names.length) return null;
  const short = names.map((name) => words(name.slice(prefix.length)));
  const rows = engines.map((engine) => {
    const cells = names.map((name, index) => {
      const of = checks.filter((one) => one.engine === engine && one.check.name === name);
      const broken = of.filter(({ check }) => check.status === "broken").length;
      const near = of.filter((one) => one.share <= alike).length;
      const text = of.length ? `${share(near, of.length)} of ${of.length}` : "\u2013";
      return h("td", { "data-label": short[index] }, text, broken ? " " : null, broken ? h("span", { class: "reason" }, `${broken} broken`) : null);
    });
    return h("tr", {}, h("th", { scope: "row" }, engine.label), ...cells);
  });
  const note = (name: string): string => model.page.report.invariants.find((one) => one.name === name)?.definition ?? "";
  return h(
    "div",
    { class: "relations" },
    h("h3", {}, "Which symmetries hold"),
    h(
      "p",
      { class: "lede" },
      `Every scene ran again as ${count(names.length, "image")} of itself. `,
      "The share of the cases in which both move alike within 0.01 % of scale, and in how many they differ by more than round-off, the method or its thresholds explain.",
    ),
    table("Relations kept", ["engine", ...short], rows, "numbers"),
    h("dl", {}, ...names.flatMap((name, index) => [h("dt", {}, short[index]), h("dd", {}, note(name))])),
  );
}
