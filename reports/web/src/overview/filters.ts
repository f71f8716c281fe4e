// What chooses the overview's rows, columns and numbers. It holds no state: it shows the address's view and changes it.
import { show, type View } from "../address";
import { h } from "../dom";
import type { Model } from "../model";
import { troubles } from "../narrowed";
import { measures } from "./measures";
import { keys, sorting } from "./order";

interface Control {
  element: HTMLElement;
  take: (view: View) => void; // the address's
}

type Present = () => View;

function changed(view: View, key: string, values: string[]): View {
  const next = new URLSearchParams(view);
  next.delete(key);
  for (const value of values) next.append(key, value);
  return next;
}

/** Buttons that stay pressed; none pressed means all. Nothing to choose from: no control. */
function pills(key: string, choices: string[], present: Present): Control | null {
  if (choices.length < 2) return null;
  const buttons = choices.map((choice) => {
    const button = h("button", { type: "button", class: "pill", "aria-pressed": "false" }, choice || "own");
    button.addEventListener("click", () => {
      const pressed = new Set(present().getAll(key));
      if (!pressed.delete(choice)) pressed.add(choice);
      show(changed(present(), key, pressed.size < choices.length ? [...pressed] : []));
    });
    return { choice, button };
  });
  return {
    element: h("fieldset", {}, h("legend", {}, key), ...buttons.map(({ button }) => button)),
    take: (view) => {
      for (const { choice, button } of buttons) button.setAttribute("aria-pressed", String(view.getAll(key).includes(choice)));
    },
  };
}

/** One of several; the first is what the address need not say. */
function select(key: string, label: string, choices: { value: string; name: string }[], present: Present): Control {
  const options = choices.map(({ value, name }) => h("option", { value }, name));
  const element = h("select", {}, ...options);
  element.addEventListener("change", () => show(changed(present(), key, element.value ? [element.value] : [])));
  return {
    element: h("label", {}, h("span", {}, label), element),
    take: (view) => {
      const wanted = options.find(({ value }) => value === (view.get(key) ?? "")) ?? options[0];
      if (wanted) wanted.selected = true;
    },
  };
}

function search(present: Present): Control {
  const input = h("input", { type: "search", placeholder: "name or parameter", spellcheck: "false", autocomplete: "off" });
  // Each letter takes the place of the one before it in the history.
  input.addEventListener("input", () => show(changed(present(), "scenario", input.value ? [input.value] : []), true));
  return {
    element: h("label", {}, h("span", {}, "scenario"), input),
    take: (view) => {
      const value = view.get("scenario") ?? "";
      if (input.value !== value) input.value = value;
    },
  };
}

const named = (names: string[]): { value: string; name: string }[] => names.map((name) => ({ value: name, name }));

export function filters(model: Model): Control {
  let view: View = new URLSearchParams();
  const present: Present = () => view;
  const engines = model.engines.filter(({ exact }) => !exact);
  const distinct = (values: string[]): string[] => [...new Set(values)];
  const orders = keys(engines).flatMap(({ id, name }) => [
    { value: id, name },
    { value: `-${id}`, name: `${name}, downwards` },
  ]);
  const all = [
    pills("engine", distinct(engines.map(({ engine }) => engine)), present),
    pills("method", distinct(engines.map(({ method }) => method)), present),
    search(present),
    select("verdict", "verdict", [{ value: "", name: "any" }, ...named(Object.keys(troubles))], present),
    select("show", "number", measures.map(({ name }, index) => ({ value: index ? name : "", name })), present),
    select("sort", "order", [{ value: "", name: "as listed" }, ...orders], present),
  ].filter((control): control is Control => control !== null);
  const reset = h("button", { type: "button", class: "quiet" }, "Show all");
  reset.addEventListener("click", () => show(new URLSearchParams()));
  return {
    element: h("div", { class: "filters", role: "search", "aria-label": "What the overview shows" }, ...all.map(({ element }) => element), reset),
    take: (taken) => {
      view = taken;
      for (const control of all) control.take(taken);
      const { id } = sorting(taken);
      reset.hidden = !id && [...taken.keys()].length === 0;
    },
  };
}
