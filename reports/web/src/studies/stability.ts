// Where methods fail: a heat map for each map and method, and one table of the limits of each method.
import type { Study } from "../data";
import type { StudyView } from "../model";
import { h, slug, table } from "../dom";
import { folded } from "../folded";
import { enumerate, given, words } from "../format";
import { heat_map, outcome_legend } from "./heat_map";
import { is_absent, stability_model, typical_row, type Axis, type Bracket, type Panel, type StabilityMap, type StabilityModel } from "./stability_model";

/** "26.57 deg (26.58: drifts)" */
function limit_text(x: Axis, { low, high, outcome }: Bracket, why: string): string {
  if (low === null && high === null) return "not supported";
  if (low === null) return `none (${outcome}${outcome === "fails" ? `: ${why}` : ""})`;
  const value = given(low, x.unit, 4);
  if (high === null) return why ? `${value}, more is not supported` : `${value} and more`;
  return `${value} (${given(high, "", 4)}: ${outcome})`;
}

function note_of(map: StabilityMap, panel: Panel): string {
  const row = typical_row(panel);
  const bracket = row?.brackets[0];
  if (!row || !bracket) return "";
  if (is_absent(panel)) return panel.why;
  const where = panel.y ? ` at ${panel.y.name} ${given(row.y, panel.y.unit, 3)}` : "";
  const theory = bracket.theory === "never" ? "; theory: no limit" : typeof bracket.theory === "number" ? `; theory: ${given(bracket.theory, "", 4)}` : "";
  return `${map.boundaries[0]?.name ?? ""}${where}: ${limit_text(map.x, bracket, panel.why)}${theory}`;
}

function agreement_table(map: StabilityMap): HTMLElement | null {
  if (!map.agreements.length) return null;
  const unit = map.x.logarithmic ? "" : map.x.unit;
  const difference = (value: number): string => (map.x.logarithmic ? `${given(100 * value, "", 2)} %` : given(value, unit, 2));
  const rows = () => map.agreements.map(({ engine, boundary, rows, agree, worst }) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, engine),
      h("td", { "data-label": "boundary" }, boundary),
      h("td", { "data-label": "rows that agree with theory" }, `${agree} of ${rows}`),
      h("td", { "data-label": "largest difference" }, worst === null ? "\u2013" : difference(worst)),
    ),
  );
  const heads = ["engine", "boundary", "rows that agree with theory", "largest difference"];
  return folded("Measured boundaries against theory", () => [table("Rows whose boundary agrees with theory", heads, rows(), "numbers")]);
}

function map_section(model: StabilityModel, map: StabilityMap): HTMLElement {
  const seen = new Set(map.panels.flatMap(({ rows }) => rows.flatMap(({ cells }) => cells.map(({ outcome }) => outcome.letter))));
  const shown = map.panels.filter((panel) => !is_absent(panel));
  const absent = map.panels.filter(is_absent);
  const theories = map.boundaries.filter(({ source }) => source).map(({ name, source }) => `${name}: ${source}`);
  return h(
    "section",
    { id: slug(map.name), class: "chapter" },
    h("h2", {}, words(map.name)),
    h("p", { class: "lede" }, map.question),
    h(
      "article",
      { class: "case" },
      outcome_legend(model.outcomes.filter(({ letter }) => seen.has(letter))),
      h(
        "p",
        {},
        `The difficulty grows to the right. The solid line is the bisected boundary, as wide as its bracket${theories.length ? "; the dashed line is the boundary by theory" : ""}.`,
      ),
      h("div", { class: "charts maps" }, ...shown.map((panel) => heat_map(map, panel, note_of(map, panel)))),
      absent.length ? h("p", { class: "absence" }, `Not supported by ${enumerate(absent.map(({ engine }) => engine))}.`) : null,
      ...[...map.failed].map(([engine, why]) => h("p", { class: "absence" }, `${engine} has no limit here: ${why}.`)),
      folded("What counts as failure, and the theory", () => [
        h("ul", { class: "metrics" }, ...map.metrics.map((metric) => h("li", {}, metric)), ...theories.map((theory) => h("li", {}, `theory for ${theory}`))),
      ]),
      agreement_table(map),
    ),
  );
}

/** The engines of the table. An engine that only one of several maps runs, as a variant of another, is left out. */
function compared(model: StabilityModel): string[] {
  const labels = new Map<string, number>();
  for (const { panels, failed } of model.maps) {
    for (const engine of new Set([...panels.map(({ engine }) => engine), ...failed.keys()])) labels.set(engine, (labels.get(engine) ?? 0) + 1);
  }
  return [...labels].filter(([, maps]) => maps > 1 || model.maps.length === 1).map(([label]) => label);
}

function overall(model: StabilityModel): HTMLElement {
  const labels = compared(model);
  const columns = model.maps.map((map) => {
    const where = map.y ? `, ${map.y.name} ${given(map.typical, map.y.unit, 3)}` : "";
    return { map, head: `${map.x.name}${map.x.unit ? ` (${map.x.unit})` : ""}${where}` };
  });
  const heads = columns.map(({ map, head }) => h("span", {}, h("a", { href: `#${slug(map.name)}` }, words(map.name)), h("br"), head));
  const rows = labels.map((label) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, label),
      ...columns.map(({ map, head }) => {
        const panel = map.panels.find(({ engine }) => engine === label);
        const bracket = panel && typical_row(panel)?.brackets[0];
        const name = `${words(map.name)}: ${head}`;
        const why = map.failed.get(label);
        if (why !== undefined) return h("td", { "data-label": name, title: why }, "failed");
        if (!bracket || (bracket.low === null && bracket.high === null)) return h("td", { class: "none", "data-label": name }, "\u2013");
        const open = bracket.high === null && !panel.why ? "\u2265 " : "";
        const text = bracket.low === null ? "none" : open + given(bracket.low, "", 4);
        return h("td", { "data-label": name, title: limit_text(map.x, bracket, panel.why) }, map.best.includes(label) ? h("strong", {}, text) : text);
      }),
    ),
  );
  return h(
    "section",
    { id: "limits" },
    h("h2", {}, "Limits of each method"),
    h(
      "p",
      { class: "lede" },
      "The last value that holds, at the method\u2019s default settings and at the value in the column\u2019s head; \u2265 if the map ends before it fails. The best of each column is bold; where physics has a boundary, all methods that agree with it.",
    ),
    table("Limits of each method", ["method", ...heads], rows, "numbers limits"),
  );
}

export function stability(study: Study): StudyView {
  const model = stability_model(study);
  return {
    sentence: model.sentence,
    sections: [
      { id: "limits", name: "Limits", content: () => overall(model) },
      ...model.maps.map((map) => ({ id: slug(map.name), name: words(map.name), content: () => map_section(model, map) })),
    ],
  };
}
