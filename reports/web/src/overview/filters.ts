// The overview's filters: the controls, and the part of the report that they select. The controls hold no state: they
// show the view in the address and change it.
import { show, type View } from "../address";
import { shows_engine } from "../chosen";
import { h } from "../dom";
import type { Case, Chapter, Model } from "../model";
import { keys, measures, sorting } from "./matrix";

/** Filters of cases by the verdicts of their engines. */
const verdict_filters: Record<string, (item: Case) => boolean> = {
  "something is wrong": ({ entries }) => entries.some(({ run }) => run.verdict === "wrong" || run.verdict === "failed"),
  "all is right": ({ entries }) => entries.every(({ run, engine }) => engine.exact || run.verdict === "right"),
  "something is coarse": ({ entries }) => entries.some(({ run }) => run.verdict === "coarse"),
  "something has no evidence": ({ entries }) => entries.some(({ run }) => run.verdict === "no evidence"),
  "engines differ": ({ entries }) => new Set(entries.filter(({ engine }) => !engine.exact).map(({ run }) => run.verdict)).size > 1,
  "something is not supported": ({ entries }) => entries.some(({ run }) => run.verdict === "not supported"),
};

export function shows_case(view: View, { scenario, variant }: { scenario: string; variant: string }): boolean {
  const words = view.get("scenario") ?? "";
  const text = `${scenario} ${variant}`.toLowerCase();
  return words.toLowerCase().split(/\s+/).every((word) => text.includes(word));
}

/** The engines and cases that the view selects. */
export function filtered(model: Model, view: View): Model {
  const engines = model.engines.filter((engine) => shows_engine(view, engine));
  const verdict = verdict_filters[view.get("verdict") ?? ""] ?? (() => true);
  const chapters = model.chapters.flatMap((chapter): Chapter[] => {
    const cases = chapter.cases
      .filter((item) => shows_case(view, item))
      .map((item) => ({ ...item, entries: item.entries.filter(({ engine }) => engines.includes(engine)) }))
      .filter((item) => item.entries.some(({ engine }) => !engine.exact) && verdict(item));
    return cases.length ? [{ ...chapter, cases }] : [];
  });
  return { ...model, engines, chapters };
}

export interface Control {
  element: HTMLElement;
  update: (view: View) => void;
}

export type CurrentView = () => View;

function changed(view: View, key: string, values: string[]): View {
  const next = new URLSearchParams(view);
  next.delete(key);
  for (const value of values) next.append(key, value);
  return next;
}

/** Toggle buttons; none pressed means all. Returns null if there is nothing to choose from. */
function pills(key: string, choices: string[], current: CurrentView): Control | null {
  if (choices.length < 2) return null;
  const buttons = choices.map((choice) => {
    const button = h("button", { type: "button", class: "pill", "aria-pressed": "false" }, choice || "own");
    button.addEventListener("click", () => {
      const pressed = new Set(current().getAll(key));
      if (!pressed.delete(choice)) pressed.add(choice);
      show(changed(current(), key, pressed.size < choices.length ? [...pressed] : []));
    });
    return { choice, button };
  });
  return {
    element: h("fieldset", {}, h("legend", {}, key), ...buttons.map(({ button }) => button)),
    update: (view) => {
      for (const { choice, button } of buttons) button.setAttribute("aria-pressed", String(view.getAll(key).includes(choice)));
    },
  };
}

/** One of several choices; the first is the default, which the address leaves out. */
export function select(key: string, label: string, choices: { value: string; name: string }[], current: CurrentView): Control {
  const options = choices.map(({ value, name }) => h("option", { value }, name));
  const element = h("select", {}, ...options);
  element.addEventListener("change", () => show(changed(current(), key, element.value ? [element.value] : [])));
  return {
    element: h("label", {}, h("span", {}, label), element),
    update: (view) => {
      const wanted = options.find(({ value }) => value === (view.get(key) ?? "")) ?? options[0];
      if (wanted) wanted.selected = true;
    },
  };
}

function search(current: CurrentView): Control {
  const input = h("input", { type: "search", placeholder: "name or parameter", spellcheck: "false", autocomplete: "off" });
  // Typing replaces the entry of the browser's history instead of adding one for each letter.
  input.addEventListener("input", () => show(changed(current(), "scenario", input.value ? [input.value] : []), true));
  return {
    element: h("label", {}, h("span", {}, "scenario"), input),
    update: (view) => {
      const value = view.get("scenario") ?? "";
      if (input.value !== value) input.value = value;
    },
  };
}

const named = (names: string[]): { value: string; name: string }[] => names.map((name) => ({ value: name, name }));

export function filters(model: Model): Control {
  let view: View = new URLSearchParams();
  const current: CurrentView = () => view;
  const engines = model.engines.filter(({ exact }) => !exact);
  const distinct = (values: string[]): string[] => [...new Set(values)];
  const orders = keys(engines).flatMap(({ id, name }) => [
    { value: id, name },
    { value: `-${id}`, name: `${name}, descending` },
  ]);
  const all = [
    pills("engine", distinct(engines.map(({ engine }) => engine)), current),
    pills("method", distinct(engines.map(({ method }) => method)), current),
    search(current),
    select("verdict", "verdict", [{ value: "", name: "any" }, ...named(Object.keys(verdict_filters))], current),
    select("show", "number", measures.map(({ name }, index) => ({ value: index ? name : "", name })), current),
    select("sort", "order", [{ value: "", name: "as listed" }, ...orders], current),
  ].filter((control): control is Control => control !== null);
  const reset = h("button", { type: "button", class: "quiet" }, "Show all");
  reset.addEventListener("click", () => show(new URLSearchParams()));
  return {
    element: h("div", { class: "filters", role: "search", "aria-label": "Filters of the overview" }, ...all.map(({ element }) => element), reset),
    update: (next) => {
      view = next;
      for (const control of all) control.update(next);
      reset.hidden = !sorting(next).id && [...next.keys()].length === 0;
    },
  };
}
