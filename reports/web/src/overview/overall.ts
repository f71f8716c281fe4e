// The speed study in one chart: how long each method takes for the same error, over all cases.
import { equal_error_chart } from "../charts/equal_error";
import { h } from "../dom";
import type { Model } from "../model";
import { study_id } from "../sections/studies";
import { speed_model } from "../studies/speed_model";

export function overall(model: Model): HTMLElement | null {
  const study = model.page.studies.find(({ study }) => study === "speed");
  if (!study) return null;
  return h(
    "div",
    {},
    equal_error_chart(speed_model(study)),
    h("p", { class: "basis" }, h("a", { href: `#${study_id(study)}` }, "The study it is taken from")),
  );
}
