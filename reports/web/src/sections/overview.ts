// Every case against every engine, and what accuracy costs: the part of it that the address's view asks for.
import { watch } from "../address";
import { cost_chart } from "../charts/cost";
import { legend } from "../charts/look";
import { h } from "../dom";
import { count } from "../format";
import type { Model } from "../model";
import { narrowed } from "../narrowed";
import { filters } from "../overview/filters";
import { matrix } from "../overview/matrix";
import { measures } from "../overview/measures";
import { overall } from "../overview/overall";
import { since_baseline } from "../overview/since_baseline";

const cases_in = ({ chapters }: Model): number => chapters.reduce((sum, { cases }) => sum + cases.length, 0);

export function overview(model: Model): HTMLElement {
  const about = h("p", { class: "lede" });
  const choice = filters(model);
  const shown = h("p", { class: "basis", role: "status" });
  const table = h("div", {});
  const cost = h("div", {});
  const speed = overall(model);
  const total = cases_in(model);
  watch((view) => {
    const part = narrowed(model, view);
    const engines = part.engines.filter(({ exact }) => !exact);
    const measure = measures.find(({ name }) => name === view.get("show")) ?? measures[0];
    const cases = cases_in(part);
    about.textContent = `${measure.about} A cell leads to its evidence.`;
    choice.take(view);
    shown.textContent = cases ? `${cases} of ${count(total, "case")} shown` : "No case is like that.";
    shown.hidden = view.toString() === "";
    table.replaceChildren(...(cases ? [matrix(part, engines, view, measure), legend(engines)] : []));
    cost.replaceChildren(...[cost_chart(part)].filter((chart) => chart !== null));
    speed?.take(view);
  });
  return h(
    "section",
    { id: "overview" },
    h("h2", {}, "Who is right"),
    about,
    choice.element,
    shown,
    table,
    since_baseline(model),
    h("div", { class: "pair" }, cost, speed?.element),
  );
}
