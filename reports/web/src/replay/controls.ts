// Buttons, boxes and choices that say what they do.
import { h, svg } from "../dom";

const shapes = {
  play: "M4 2l10 6-10 6z",
  pause: "M3 2h4v12H3zM9 2h4v12H9z",
  start: "M2 2h2.5v12H2zM14 2v12L5 8z",
  back: "M10 2v12L3 8zM11.5 2H13v12h-1.5z",
  on: "M6 2l7 6-7 6zM3 2h1.5v12H3z",
};

export const icon = (shape: keyof typeof shapes): SVGElement =>
  svg("svg", { viewBox: "0 0 16 16", "aria-hidden": "true" }, svg("path", { d: shapes[shape] }));

/** Its face says what it does, or else `about` does. */
export function button(about: string, face: string | SVGElement, act: () => void): HTMLButtonElement {
  const plain = typeof face === "string" && /^[\w ]+$/.test(face);
  const made = h("button", { type: "button", title: about, ...(plain ? {} : { "aria-label": about }) }, face);
  made.addEventListener("click", act);
  return made;
}

/** Its label is the `name`. */
export function check(name: string, on: boolean, act: (on: boolean) => void): HTMLInputElement {
  const box = h("input", { type: "checkbox", name });
  box.checked = on;
  box.addEventListener("change", () => act(box.checked));
  return box;
}

export function choice(about: string, values: (readonly [string, string])[], act: (value: string) => void): HTMLSelectElement {
  const made = h("select", { "aria-label": about, title: about }, ...values.map(([value, text]) => h("option", { value }, text)));
  made.addEventListener("change", () => act(made.value));
  return made;
}
