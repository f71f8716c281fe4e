// The speed study in one chart: how long each method takes for the same error, over the cases that the view asks for.
import type { View } from "../address";
import { equal_error_chart } from "../charts/equal_error";
import { h } from "../dom";
import { count } from "../format";
import type { Model } from "../model";
import { chosen, matching } from "../narrowed";
import { study_id } from "../sections/studies";
import { factors_over } from "../studies/equal_error";
import { speed_model } from "../studies/speed_model";

/** Shows another view when it is told of one; null where the report has no such study. */
export function overall(model: Model): { element: HTMLElement; take: (view: View) => void } | null {
  const study = model.page.studies.find(({ study }) => study === "speed");
  if (!study) return null;
  const { cases, standard } = speed_model(study);
  const holder = h("div", {});
  const take = (view: View): void => {
    const shown = cases.filter((place) => matching(view, place));
    const factors = factors_over(shown).filter(({ engine }) => chosen(view, engine));
    const over = shown.length === cases.length ? "all cases" : count(shown.length, "case");
    holder.replaceChildren(
      factors.length ? equal_error_chart(standard, factors, over) : h("p", { class: "absence" }, "The study of speed has nothing like that."),
    );
  };
  const element = h("div", {}, holder, h("p", { class: "basis" }, h("a", { href: `#${study_id(study)}` }, "The study it is taken from")));
  return { element, take };
}
