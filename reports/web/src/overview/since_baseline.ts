// Whether anything is otherwise than in the accepted baseline, in a sentence.
import { h } from "../dom";
import type { Model } from "../model";
import { study_id } from "../sections/studies";
import { sentence } from "../studies/baseline";

export function since_baseline(model: Model): HTMLElement | null {
  const study = model.page.studies.find(({ study }) => study === "baseline");
  if (!study) return null;
  return h("p", { class: "since" }, h("strong", {}, "Since the baseline: "), `${sentence(study)} `, h("a", { href: `#${study_id(study)}` }, "What changed"));
}
