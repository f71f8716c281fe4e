// The search field of the navigation: scenarios by group, and cases, whose names have all the typed words. In place of a
// row of links that would be longer than the screen.
import { h, slug } from "./dom";
import type { Chapter, Model } from "./model";

const most_cases = 30;

const has_all = (words: string[], text: string): boolean => words.every((word) => text.toLowerCase().includes(word));

function by_group(chapters: Chapter[]): [string, Chapter[]][] {
  const groups = new Map<string, Chapter[]>();
  for (const chapter of chapters) {
    const group = chapter.note?.group || "others";
    groups.set(group, [...(groups.get(group) ?? []), chapter]);
  }
  return [...groups].sort(([a], [b]) => a.localeCompare(b, "en"));
}

const link = (id: string, name: string): HTMLElement => h("li", {}, h("a", { href: `#${id}` }, name));

/** "joints: Ropes stretch ..." */
function group_head(model: Model, name: string): HTMLElement {
  const note = (model.page.report.groups ?? []).find((one) => one.name === name);
  return h("p", {}, h("strong", {}, note?.title ?? name), note ? `: ${note.stake}` : "");
}

/** What fits the words: the scenarios by group, then single cases. */
function found(model: Model, text: string): HTMLElement[] {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  const chapters = model.chapters.filter(({ name, note }) => has_all(words, `${name} ${note?.group ?? ""} ${note?.question ?? ""}`));
  const groups = by_group(chapters).map(([group, own]) => h("div", {}, group_head(model, group), h("ul", {}, ...own.map(({ name }) => link(slug(name), name)))));
  const cases = words.length ? model.chapters.flatMap((chapter) => chapter.cases).filter(({ scenario, variant }) => has_all(words, `${scenario} ${variant}`)) : [];
  const shown = cases.slice(0, most_cases).map(({ scenario, variant }) => link(slug(scenario, variant), `${scenario}, ${variant}`));
  if (shown.length) groups.push(h("div", {}, h("strong", {}, cases.length > most_cases ? `cases, ${most_cases} of ${cases.length}` : "cases"), h("ul", {}, ...shown)));
  return groups.length ? groups : [h("p", { class: "absence" }, "Nothing has such a name.")];
}

export function finder(model: Model): HTMLElement {
  const input = h("input", { type: "search", placeholder: "Find a scenario or case", "aria-label": "Find a scenario or case", spellcheck: "false", autocomplete: "off" });
  const results = h("div", { class: "results", role: "region", "aria-label": "Scenarios and cases", hidden: "" });
  const element = h("div", { class: "finder" }, input, results);
  const close = (): void => {
    results.hidden = true;
  };
  const update = (): void => {
    results.replaceChildren(...found(model, input.value));
    results.hidden = false;
  };
  input.addEventListener("input", update);
  input.addEventListener("focus", update);
  input.addEventListener("keydown", ({ key }) => {
    if (key === "Enter") results.querySelector("a")?.click();
    if (key === "Escape") close();
  });
  element.addEventListener("keydown", ({ key }) => key === "Escape" && close());
  results.addEventListener("click", ({ target }) => target instanceof Element && target.closest("a") && close());
  document.addEventListener("pointerdown", ({ target }) => target instanceof Node && !element.contains(target) && close());
  element.addEventListener("focusout", ({ relatedTarget }) => relatedTarget instanceof Node && !element.contains(relatedTarget) && close());
  return element;
}
