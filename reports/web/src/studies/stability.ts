// Where methods fail: a heat map for each map and method, and one table of what each method stands.
import type { Study } from "../data";
import type { StudyView } from "../model";
import { h, slug, table } from "../dom";
import { folded } from "../folded";
import { count, enumerate, given, words } from "../format";
import { fate_legend, heat_map } from "./heat_map";
import { best_of, is_absent, stability_model, typical_row, type Axis, type Bracket, type Panel, type StabilityMap, type StabilityModel } from "./stability_model";

/** "26.57 deg (26.58: drifts)" */
function stands(x: Axis, { low, high, outcome }: Bracket, why: string): string {
  if (low === null && high === null) return "not supported";
  if (low === null) return `none (${outcome})`;
  const value = given(low, x.unit, 4);
  if (high === null) return why ? `${value}, no more supported` : `${value} and more`;
  return `${value} (${given(high, "", 4)}: ${outcome})`;
}

function note_of(map: StabilityMap, panel: Panel): string {
  const row = typical_row(panel);
  const bracket = row?.brackets[0];
  if (!row || !bracket) return "";
  if (is_absent(panel)) return panel.why;
  const where = panel.y ? ` at ${panel.y.name} ${given(row.y, panel.y.unit, 3)}` : "";
  const theory = bracket.theory === "never" ? "; theory: for ever" : typeof bracket.theory === "number" ? `; theory: ${given(bracket.theory, "", 4)}` : "";
  return `${map.boundaries[0]?.name ?? ""}${where}: ${stands(map.x, bracket, panel.why)}${theory}`;
}

function agreement_table(map: StabilityMap): HTMLElement | null {
  if (!map.agreements.length) return null;
  const unit = map.x.logarithmic ? "" : map.x.unit;
  const off = (value: number): string => (map.x.logarithmic ? `${given(100 * value, "", 2)} %` : given(value, unit, 2));
  const rows = () => map.agreements.map(({ engine, boundary, rows, agree, worst }) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, engine),
      h("td", { "data-label": "boundary" }, boundary),
      h("td", { "data-label": "rows as theory says" }, `${agree} of ${rows}`),
      h("td", { "data-label": "off by at most" }, worst === null ? "\u2013" : off(worst)),
    ),
  );
  const heads = ["", "boundary", "rows as theory says", "off by at most"];
  return folded("Measured boundaries against theory", () => [table("Rows whose boundary is where theory has it", heads, rows(), "numbers")]);
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
      fate_legend(model.outcomes.filter(({ letter }) => seen.has(letter))),
      h(
        "p",
        {},
        `Left is easy, right is hard. The solid line is the bisected boundary, as wide as its bracket${theories.length ? "; the broken line is theory\u2019s" : ""}.`,
      ),
      h("div", { class: "charts maps" }, ...shown.map((panel) => heat_map(map, panel, note_of(map, panel)))),
      absent.length ? h("p", { class: "absence" }, `Cannot run it: ${enumerate(absent.map(({ engine }) => engine))}.`) : null,
      folded("What counts as failing, and what theory says", () => [
        h("ul", { class: "metrics" }, ...map.metrics.map((metric) => h("li", {}, metric)), ...theories.map((theory) => h("li", {}, `theory, ${theory}`))),
      ]),
      agreement_table(map),
    ),
  );
}

/** Methods that only one map tries, as forms of another, are told of in that map alone. */
function compared(model: StabilityModel): string[] {
  const labels = new Map<string, number>();
  for (const { panels } of model.maps) {
    for (const { engine } of panels) labels.set(engine, (labels.get(engine) ?? 0) + 1);
  }
  return [...labels].filter(([, maps]) => maps > 1 || model.maps.length === 1).map(([label]) => label);
}

function overall(model: StabilityModel): HTMLElement {
  const labels = compared(model);
  const columns = model.maps.map((map) => {
    const where = map.y ? `, ${map.y.name} ${given(map.typical, map.y.unit, 3)}` : "";
    return { map, head: `${map.x.name}${map.x.unit ? ` (${map.x.unit})` : ""}${where}`, best: best_of(map, labels) };
  });
  const heads = columns.map(({ map, head }) => h("span", {}, h("a", { href: `#${slug(map.name)}` }, words(map.name)), h("br"), head));
  const rows = labels.map((label) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, label),
      ...columns.map(({ map, head, best }) => {
        const panel = map.panels.find(({ engine }) => engine === label);
        const bracket = panel && typical_row(panel)?.brackets[0];
        const name = `${words(map.name)}: ${head}`;
        if (!bracket || (bracket.low === null && bracket.high === null)) return h("td", { class: "none", "data-label": name }, "\u2013");
        const open = bracket.high === null && !panel.why ? "\u2265 " : "";
        const text = bracket.low === null ? "none" : open + given(bracket.low, "", 4);
        return h("td", { "data-label": name, title: stands(map.x, bracket, panel.why) }, best.has(label) ? h("strong", {}, text) : text);
      }),
    ),
  );
  return h(
    "section",
    { id: "stands" },
    h("h2", {}, "What each method stands"),
    h(
      "p",
      { class: "lede" },
      "The last value at which it held, at its own settings and at the place named in the column\u2019s head; \u2265 where the map ends before it fails. What stands out is the best of a column; where nature has a boundary, all who have it there.",
    ),
    table("What each method stands", ["method", ...heads], rows, "numbers stands"),
  );
}

function sentence(model: StabilityModel): string {
  const labels = compared(model);
  const best = model.maps.map((map) => best_of(map, labels));
  const [most] = labels.map((label) => ({ label, wins: best.filter((of) => of.has(label)).length })).sort((a, b) => b.wins - a.wins);
  const first = most?.wins ? `No method stands more than ${most.label} in ${most.wins} of ${count(model.maps.length, "map")}.` : `${count(model.maps.length, "map")}.`;
  const rows = model.maps.flatMap(({ agreements }) => agreements);
  const total = rows.reduce((sum, one) => sum + one.rows, 0);
  const agree = rows.reduce((sum, one) => sum + one.agree, 0);
  return total ? `${first} Theory knows ${total} of the boundaries: ${agree} are where it has them.` : first;
}

export function stability(study: Study): StudyView {
  const model = stability_model(study);
  return {
    sentence: sentence(model),
    sections: [
      { id: "stands", name: "What each stands", content: () => overall(model) },
      ...model.maps.map((map) => ({ id: slug(map.name), name: words(map.name), content: () => map_section(model, map) })),
    ],
  };
}
