// In place of a page that would be wrong.
import { h } from "../dom";
import { count } from "../format";

const most_shown = 20;

export function problems(found: string[]): HTMLElement {
  const more = found.length - most_shown;
  return h(
    "main",
    { class: "problems" },
    h("h1", {}, "This report cannot be shown"),
    h("p", {}, "It is damaged, or another version of Plumb wrote it. Make it again with ", h("code", {}, "./plumb report"), "."),
    h("ul", {}, ...found.slice(0, most_shown).map((problem) => h("li", {}, problem))),
    more > 0 ? h("p", {}, `and ${count(more, "more problem")}`) : null,
  );
}
