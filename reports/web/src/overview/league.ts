// The league table: for each engine, how far off its checks are by the ruler that is the same for all, and beside it how
// many cases its method explains.
import type { Verdict } from "../data";
import { h, table } from "../dom";
import { share } from "../format";
import { relative_of, reported, type Engine, type Model } from "../model";
import { verdict_meanings } from "../pieces";

const grades = [0.1, 0.01, 0.001, 0.0001];

export function league(model: Model, engines: Engine[]): HTMLElement {
  const entries = model.chapters.flatMap(({ cases }) => cases.flatMap((item) => item.entries));
  const given = new Set(entries.filter(({ engine }) => !engine.exact).map(({ run }) => run.verdict));
  const verdicts = (Object.keys(verdict_meanings) as Verdict[]).filter((verdict) => given.has(verdict));
  const heads = ["engine", "checks", ...grades.map((grade) => `within ${100 * grade} %`), "not a test", ...verdicts];
  const rows = engines.map((engine) => {
    const runs = entries.filter((entry) => entry.engine === engine).map(({ run }) => run);
    const checks = runs.flatMap(reported);
    const within = grades.map((grade) => checks.filter((check) => relative_of(check) <= grade).length);
    const cells = [
      String(checks.length),
      ...within.map((many) => share(many, checks.length)),
      String(checks.filter(({ evidence }) => !evidence).length),
      ...verdicts.map((verdict) => String(runs.filter((run) => run.verdict === verdict).length)),
    ];
    return h("tr", {}, h("th", { scope: "row" }, engine.label), ...cells.map((cell, index) => h("td", { "data-label": heads[index + 1] }, cell)));
  });
  return h(
    "div",
    {},
    h(
      "p",
      { class: "lede" },
      "How far off: the share of an engine\u2019s checks whose error is within so much of the scene\u2019s own scale. ",
      "Whether that is explained: the number of cases by verdict. A check is not a test if its tolerance is above 5 % of scale.",
    ),
    table("Engines by both rulers", heads, rows, "numbers league"),
  );
}
