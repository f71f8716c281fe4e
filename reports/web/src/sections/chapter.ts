// One scenario: its question, and for each case the charts and the tables they rest on.
import { case_charts } from "../charts/case";
import { legend } from "../charts/look";
import { h, slug } from "../dom";
import { given, words } from "../format";
import type { Case, Chapter, Model } from "../model";
import { Cursor } from "../replay/cursor";
import { replay_figure } from "../replay/view";
import { checks } from "./checks";
import { evidence } from "./evidence";
import { horizon } from "./horizon";
import { invariants } from "./invariants";
import { numbers } from "./numbers";

function parameters(place: Case, chapter: Chapter): HTMLElement {
  const about = new Map(chapter.note?.parameters.map((parameter) => [parameter.name, parameter]));
  const items = Object.entries(place.parameters).map(([name, value]) => {
    const known = about.get(name);
    return h("div", known ? { title: known.about } : {}, h("dt", {}, words(name)), h("dd", {}, given(value, known?.unit)));
  });
  return h("dl", { class: "parameters" }, ...items);
}

function section(place: Case, chapter: Chapter, { page }: Model): HTMLElement {
  const ends = place.entries.flatMap(({ series }) => series?.t[series.t.length - 1] ?? []);
  const cursor = new Cursor(Math.max(0, ...ends));
  const drawn = place.entries.filter(({ series }) => series).map(({ engine }) => engine);
  return h(
    "article",
    { id: slug(place.scenario, place.variant), class: "case" },
    h("h3", {}, place.variant),
    parameters(place, chapter),
    evidence(place),
    horizon(place),
    drawn.length ? legend(drawn) : null,
    replay_figure(place, cursor),
    h("div", { class: "charts" }, ...case_charts(place, cursor)),
    checks(place),
    invariants(place),
    numbers(place, page.report),
  );
}

export function chapter_section(chapter: Chapter, model: Model): HTMLElement {
  return h(
    "section",
    { id: slug(chapter.name), class: "chapter" },
    h("h2", {}, chapter.name),
    chapter.note ? h("p", { class: "lede" }, chapter.note.question) : null,
    ...chapter.cases.map((place) => section(place, chapter, model)),
  );
}
