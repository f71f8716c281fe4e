// Buttons, boxes and choices that say what they do.
// What the keyboard does, and the list that tells of it.
// Where the energy is: a bar for each engine, in three parts.
import { h, svg } from "../dom";
import { number } from "../format";
import type { Film } from "./film";

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

export interface Key {
  keys: string[]; // as KeyboardEvent has them
  shown: string;
  about: string;
  act: (event: KeyboardEvent) => void;
}

/** Elements that have a use of their own for some keys. */
function taken(event: KeyboardEvent): boolean {
  const { target, key } = event;
  if (event.ctrlKey || event.metaKey || event.altKey) return true;
  if (target instanceof HTMLSelectElement) return true;
  if (target instanceof HTMLInputElement && target.type === "range") return /^(Arrow|Home|End|Page)/.test(key);
  const pressed = target instanceof HTMLButtonElement || target instanceof HTMLInputElement || (target instanceof Element && target.tagName === "SUMMARY");
  return pressed && (key === " " || key === "Enter");
}

export function listen(element: HTMLElement, keys: Key[]): void {
  element.addEventListener("keydown", (event) => {
    if (taken(event)) return;
    const found = keys.find(({ keys }) => keys.includes(event.key) || keys.includes(event.key.toLowerCase()));
    if (!found) return;
    event.preventDefault();
    found.act(event);
  });
}

export function help(keys: Key[]): HTMLDetailsElement {
  const rows = keys.map(({ shown, about }) => h("div", {}, h("dt", {}, ...shown.split(" ").map((key) => h("kbd", {}, key))), h("dd", {}, about)));
  return h(
    "details",
    { class: "keys" },
    h("summary", {}, "Keys, and what is drawn"),
    h("p", {}, "Drag to move the picture, double-click to come nearer; once it is clicked, the wheel does so too. A click on a chart goes to its time. The shapes on bodies tell the engines apart, as those on lines in charts do."),
    h("dl", {}, ...rows),
  );
}

const parts = ["linear", "rotational", "potential"] as const;

export class Bars {
  readonly element: HTMLElement;
  private readonly rows: { film: Film; row: HTMLElement; segments: HTMLElement[]; sum: HTMLElement }[];
  private readonly floor: number; // J, from which potential energy is counted
  private readonly span: number; // J, a whole bar

  constructor(films: Film[]) {
    const ranges = films.map((film) => film.energy_range());
    this.floor = Math.min(...ranges.map(({ floor }) => floor));
    this.span = Math.max(...ranges.map(({ top }) => top)) - this.floor || 1;
    this.rows = films.map((film) => {
      const segments = parts.map((part) => h("i", { class: part, style: `background-color: ${film.engine.color}` }));
      const sum = h("span", { class: "sum" });
      const row = h("div", { class: "bar" }, h("span", {}, film.engine.label), h("span", { class: "track", "aria-hidden": "true" }, ...segments), sum);
      return { film, row, segments, sum };
    });
    const key = h("p", { class: "key" }, ...parts.flatMap((part) => [h("i", { class: part }), part]), " (from its lowest)");
    this.element = h("div", { class: "bars" }, h("strong", {}, "Energy"), ...this.rows.map(({ row }) => row), key);
  }

  show(films: Film[]): void {
    for (const { film, row, segments, sum } of this.rows) {
      row.hidden = !films.includes(film);
      if (row.hidden) continue;
      const energy = film.energy();
      const joules = [energy.linear, energy.rotational, energy.potential - this.floor];
      segments.forEach((segment, k) => (segment.style.width = `${(100 * Math.max(0, joules[k] ?? 0)) / this.span}%`));
      sum.textContent = number(joules.reduce((a, b) => a + b), "J");
    }
  }
}
