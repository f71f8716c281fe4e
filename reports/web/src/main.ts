// Builds the page from the data element, and prepares it for printing.
import { current_view, follow_address, watch } from "./address";
import { draw_all, redraw } from "./charts/figure";
import { update_legends } from "./charts/look";
import { choice_of } from "./chosen";
import { read } from "./data";
import { h, slug } from "./dom";
import { finder } from "./finder";
import { make_when_idle, unfold_all } from "./folded";
import { model_of } from "./model";
import { overview } from "./overview/overview";
import { problems } from "./pieces";
import { chapter_section } from "./sections/chapter";
import { method } from "./sections/method";
import { opening, sentence } from "./sections/opening";
import { study_id, study_page, study_section, view_of } from "./studies/page";

/** With more scenarios, a search field takes the place of their links. */
const most_links = 8;

/** The cases of a longer report are made when they are opened. */
const most_open = { cases: 16, runs: 60 };

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
  const link = (id: string, name: string) => h("a", { href: `#${id}` }, name);
  const many = model.chapters.length > most_links;
  const cases = model.chapters.flatMap((chapter) => chapter.cases);
  const runs = cases.flatMap(({ entries }) => entries).filter(({ engine }) => !engine.exact);
  const fold = cases.length > most_open.cases || runs.length > most_open.runs;
  const links = [
    link("overview", "Overview"),
    ...(many ? [finder(model)] : model.chapters.map(({ name }) => link(slug(name), name))),
    ...studies.map((study) => link(study_id(study), `Study: ${study.study}`)),
    link("method", "Method"),
  ];
  document.title = `${outcome.page.report.title || "Plumb report"}: ${sentence(model)}`;
  page?.replaceChildren(
    opening(model),
    h("nav", { "aria-label": "Sections", ...(many ? { class: "wide" } : {}) }, ...links),
    h("main", {}, overview(model), ...model.chapters.map((chapter) => chapter_section(chapter, model, fold)), ...studies.map(study_section), method(model)),
  );
}
let choice = choice_of(current_view());
watch((view) => {
  if (choice === choice_of(view)) return;
  choice = choice_of(view);
  update_legends(view);
  redraw();
});
follow_address();
make_when_idle();

let fold_again = (): void => {};
addEventListener("beforeprint", () => {
  fold_again = unfold_all();
  draw_all();
});
addEventListener("afterprint", () => fold_again());
