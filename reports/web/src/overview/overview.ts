// The overview: how far apart two engines are, the table of verdicts, the changes since the baseline, and the charts of error against cost, all for the
// part of the report that the address's view selects.
import { watch, type View } from "../address";
import { cost_chart } from "../charts/cost";
import { legend } from "../charts/look";
import { shows_engine } from "../chosen";
import { h } from "../dom";
import { count } from "../format";
import type { Model } from "../model";
import { verdict_legend } from "../pieces";
import { sentence } from "../studies/baseline";
import { study_id } from "../studies/page";
import { equal_error_chart } from "../studies/speed_charts";
import { factors_over, headline_target, speed_model, target_name } from "../studies/speed_model";
import { filtered, filters, shows_case } from "./filters";
import { groups } from "./groups";
import { key_differences } from "./key_differences";
import { league } from "./league";
import { matrix, measures } from "./matrix";
import { relations } from "./relations";

/** The speed study in one chart, for the selected cases and engines; null if the report has no such study. */
function equal_error(model: Model): { element: HTMLElement; update: (view: View) => void } | null {
  const study = model.page.studies.find(({ study }) => study === "speed");
  if (!study) return null;
  const { cases, error_targets } = speed_model(study);
  const target = headline_target(cases);
  const holder = h("div", {});
  const update = (view: View): void => {
    const shown = cases.filter((item) => shows_case(view, item));
    const factors = factors_over(shown, target).filter(({ engine }) => shows_engine(view, engine));
    const over = shown.length === cases.length ? "all cases" : count(shown.length, "case");
    holder.replaceChildren(
      factors.length ? equal_error_chart(target_name(error_targets[target] ?? 0), factors, over) : h("p", { class: "absence" }, "No case of the speed study matches."),
    );
  };
  const element = h("div", {}, holder, h("p", { class: "basis" }, h("a", { href: `#${study_id(study)}` }, "The speed study")));
  return { element, update };
}

function since_baseline(model: Model): HTMLElement | null {
  const study = model.page.studies.find(({ study }) => study === "baseline");
  if (!study) return null;
  return h("p", { class: "since" }, h("strong", {}, "Since the baseline: "), `${sentence(study)} `, h("a", { href: `#${study_id(study)}` }, "What changed"));
}

const cases_in = ({ chapters }: Model): number => chapters.reduce((sum, { cases }) => sum + cases.length, 0);

export function overview(model: Model): HTMLElement {
  const about = h("p", { class: "lede" });
  const controls = filters(model);
  const ranking = h("div", {});
  const symmetries = h("div", {});
  const stakes = h("div", {});
  const shown = h("p", { class: "basis", role: "status" });
  const table = h("div", {});
  const cost = h("div", {});
  const speed = equal_error(model);
  const total = cases_in(model);
  watch((view) => {
    const part = filtered(model, view);
    const engines = part.engines.filter(({ exact }) => !exact);
    const measure = measures.find(({ name }) => name === view.get("show")) ?? measures[0];
    const cases = cases_in(part);
    about.textContent = `${measure.about} Each cell links to the reason for its verdict.`;
    controls.update(view);
    shown.textContent = cases ? `${cases} of ${count(total, "case")} shown` : "No case matches.";
    shown.hidden = view.toString() === "";
    ranking.replaceChildren(...(cases ? [league(part, engines)] : []));
    stakes.replaceChildren(...[groups(part, engines)].filter((one) => one !== null));
    symmetries.replaceChildren(...[relations(part, engines)].filter((one) => one !== null));
    const verdicts = part.chapters.flatMap((chapter) => chapter.cases.flatMap(({ entries }) => entries.map(({ run }) => run.verdict)));
    table.replaceChildren(...(cases ? [matrix(part, engines, view, measure), legend(model.engines.filter(({ exact }) => !exact)), verdict_legend(verdicts)] : []));
    cost.replaceChildren(...[cost_chart(part)].filter((chart) => chart !== null));
    speed?.update(view);
  });
  return h(
    "section",
    { id: "overview" },
    ...key_differences(model),
    h("h2", {}, "Who is right"),
    ranking,
    stakes,
    about,
    controls.element,
    shown,
    table,
    symmetries,
    since_baseline(model),
    h("div", { class: "pair" }, cost, speed?.element),
  );
}
