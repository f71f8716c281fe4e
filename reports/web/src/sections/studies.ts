// Short forms of the studies, inside a report.
import { h, prefixed, slug } from "../dom";
import { folded } from "../folded";
import { view_of } from "../studies/views";
import type { Study } from "../study";
import { command } from "./command";

export const study_id = (study: Study): string => slug("study", study.study);

export function study_section(study: Study): HTMLElement {
  const { sentence, sections } = view_of(study);
  const [first, ...rest] = sections.map(({ content }) => () => prefixed(`${study_id(study)}--`, content()));
  return h(
    "section",
    { id: study_id(study), class: "chapter study" },
    h("h2", {}, `Study: ${study.study}`),
    h("p", { class: "lede" }, sentence),
    first?.(),
    rest.length ? folded("More of it", () => rest.map((section) => section())) : null,
    study.command ? h("div", { class: "again" }, h("p", { class: "basis" }, "A short form. The same as a page of its own:"), command(`./${study.command}`)) : null,
  );
}
