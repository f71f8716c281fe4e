// Builds the page from the data element, and prepares it for printing.
import { follow_address } from "./address";
import { draw_all } from "./charts/figure";
import { read } from "./data";
import { h, slug } from "./dom";
import { make_when_idle, unfold_all } from "./folded";
import { model_of } from "./model";
import { overview } from "./overview/overview";
import { problems } from "./pieces";
import { chapter_section } from "./sections/chapter";
import { method } from "./sections/method";
import { opening, sentence } from "./sections/opening";
import { study_id, study_page, study_section, view_of } from "./studies/page";

const page = document.getElementById("page");
const outcome = read(document.getElementById("plumb-data")?.textContent);

if ("problems" in outcome) {
  page?.replaceChildren(problems(outcome.problems));
} else if ("study" in outcome) {
  const { sentence, sections } = view_of(outcome.study);
  document.title = `Plumb study: ${outcome.study.study}: ${sentence}`;
  page?.replaceChildren(...study_page(outcome.study, sentence, sections));
} else {
  const model = model_of(outcome.page);
  const { studies } = outcome.page;
  const sections = [
    ["overview", "Overview"],
    ...model.chapters.map(({ name }) => [slug(name), name]),
    ...studies.map((study) => [study_id(study), `Study: ${study.study}`] as const),
    ["method", "Method"],
  ] as const;
  const links = sections.map(([id, name]) => h("a", { href: `#${id ?? ""}` }, name ?? ""));
  document.title = `${outcome.page.report.title || "Plumb report"}: ${sentence(model)}`;
  page?.replaceChildren(
    opening(model),
    h("nav", { "aria-label": "Sections" }, ...links),
    h("main", {}, overview(model), ...model.chapters.map((chapter) => chapter_section(chapter, model)), ...studies.map(study_section), method(model)),
  );
}
follow_address();
make_when_idle();

let fold_again = (): void => {};
addEventListener("beforeprint", () => {
  fold_again = unfold_all();
  draw_all();
});
addEventListener("afterprint", () => fold_again());
