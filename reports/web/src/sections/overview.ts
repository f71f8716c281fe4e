// Every case against every engine, and what accuracy costs.
import { cost_chart } from "../charts/cost";
import { legend } from "../charts/look";
import { h, slug, table } from "../dom";
import { share } from "../format";
import type { Case, Contender, Entry, Model } from "../model";
import { badge, gauge } from "./pieces";

function cell(entry: Entry | undefined, place: Case, head: string): HTMLTableCellElement {
  if (!entry) return h("td", { class: "none", "data-label": head }, "\u2013");
  const { run, worst } = entry;
  const judged = Number.isNaN(worst) ? null : h("span", { class: "share" }, gauge(worst), share(worst));
  const why = run.status === "ok" ? null : h("span", { class: "reason" }, run.reason);
  const link = h("a", { href: `#${slug(place.scenario, place.variant)}` }, badge(run.verdict), judged, why);
  return h("td", { "data-label": head, "data-verdict": run.verdict }, link);
}

function matrix(model: Model, engines: Contender[]): HTMLElement {
  const rows = model.chapters.flatMap((chapter) =>
    chapter.cases.map((place, index) => {
      const name = h("th", { scope: "row" }, index ? null : h("a", { href: `#${slug(chapter.name)}` }, chapter.name));
      const row = h("tr", index ? {} : { class: "first" }, name, h("td", { class: "variant" }, place.variant));
      for (const engine of engines) {
        row.append(cell(place.entries.find(({ contender }) => contender === engine), place, engine.label));
      }
      return row;
    }),
  );
  return table("Verdicts by case and engine", ["scenario", "case", ...engines.map(({ label }) => label)], rows, "matrix grouped");
}

export function overview(model: Model): HTMLElement {
  const engines = model.contenders.filter(({ exact }) => !exact);
  return h(
    "section",
    { id: "overview" },
    h("h2", {}, "Who is right"),
    h(
      "p",
      { class: "lede" },
      "Each number is the largest miss of a run, of the truth or of what holds in any case, as a share of what is allowed there; the tick on the bar is the limit. A cell leads to its evidence.",
    ),
    h("div", { class: "pair" }, h("div", {}, matrix(model, engines), legend(engines)), cost_chart(model)),
  );
}
