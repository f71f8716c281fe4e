// The page of a study: its result in a sentence, the sections of its view, unfinished jobs and the environment. Also the
// short form of a study inside a report.
import type { Study } from "../data";
import type { StudyView } from "../model";
import { h, prefixed, slug, table } from "../dom";
import { folded } from "../folded";
import { count, given, words } from "../format";
import { command, mark } from "../pieces";
import { baseline } from "./baseline";
import { find } from "./find";
import { history } from "./history";
import { model } from "./model";
import { speed } from "./speed";
import { stability } from "./stability";
import { statistics } from "./statistics";

const views: Record<string, (study: Study) => StudyView> = { baseline, find, history, model, speed, stability, statistics };

/** A study without a view of its own still shows its unfinished jobs. */
export const view_of = (study: Study): StudyView => (views[study.study] ?? (() => ({ sentence: study.about, sections: [] })))(study);

const most_shown = 200;

/** Shortens the numbers in a key. */
const readable = (key: string): string => key.replaceAll("|", ", ").replace(/\d*\.\d{4,}(e[-+]?\d+)?/g, (digits) => given(Number(digits), "", 4));

/** The jobs that crashed, failed or exceeded their limits. */
function endings(study: Study): HTMLElement | null {
  const broken = study.results.filter(({ ending }) => ending !== "done");
  if (!broken.length) return null;
  const rows = broken
    .slice(0, most_shown)
    .map(({ key, ending, reason }) => h("tr", {}, h("th", { scope: "row" }, readable(key)), h("td", {}, ending), h("td", {}, reason)));
  return h(
    "section",
    { id: "endings" },
    h("h2", {}, "Unfinished jobs"),
    h("p", { class: "lede" }, `${count(broken.length, "job")} crashed, failed or exceeded the limits of time or memory.`),
    table("Unfinished jobs", ["job", "ending", "reason"], rows),
  );
}

function environment(study: Study): HTMLElement {
  const text = (value: unknown): string => (typeof value === "string" ? value : Array.isArray(value) ? value.map(text).join(", ") : JSON.stringify(value));
  const given = Object.entries(study.configuration).map(([name, value]): [string, string] => [name, text(value)]);
  const pairs = [...given, ...Object.entries(study.environment)];
  return h(
    "section",
    { id: "environment" },
    h("h2", {}, "Environment"),
    h("dl", { class: "environment" }, ...pairs.map(([name, value]) => h("div", {}, h("dt", {}, words(name)), h("dd", {}, value)))),
  );
}

export function study_page(study: Study, sentence: string, sections: StudyView["sections"]): HTMLElement[] {
  const broken = endings(study);
  const links = [...sections, ...(broken ? [{ id: "endings", name: "Unfinished jobs" }] : []), { id: "environment", name: "Environment" }];
  return [
    h(
      "header",
      { class: "opening" },
      mark(),
      h(
        "div",
        {},
        h("p", { class: "title" }, `Plumb study: ${study.study}`),
        h("h1", {}, sentence),
        h("p", { class: "basis" }, `${study.about} \u00b7 ${count(study.results.length, "job")}`),
      ),
    ),
    h("nav", { "aria-label": "Sections" }, ...links.map(({ id, name }) => h("a", { href: `#${id}` }, name))),
    h("main", {}, ...sections.map(({ content }) => content()), broken, environment(study)),
  ];
}

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
    rest.length ? folded("More of this study", () => rest.map((section) => section())) : null,
    study.command ? h("div", { class: "again" }, h("p", { class: "basis" }, "A short form. This runs the full study, with a page of its own:"), command(`./${study.command}`)) : null,
  );
}
