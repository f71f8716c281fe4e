// The controls below a replay: buttons, check boxes, keys with their help, and bars of the energy.
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

/** A face that is not plain words gets `about` as its label. */
export function button(about: string, face: string | SVGElement, action: () => void): HTMLButtonElement {
  const plain = typeof face === "string" && /^[\w ]+$/.test(face);
  const made = h("button", { type: "button", title: about, ...(plain ? {} : { "aria-label": about }) }, face);
  made.addEventListener("click", action);
  return made;
}

/** A check box with a label of its name. */
export function check(name: string, on: boolean, action: (on: boolean) => void): HTMLInputElement {
  const box = h("input", { type: "checkbox", name });
  box.checked = on;
  box.addEventListener("change", () => action(box.checked));
  return box;
}

export function choice(about: string, values: (readonly [string, string])[], action: (value: string) => void): HTMLSelectElement {
  const made = h("select", { "aria-label": about, title: about }, ...values.map(([value, text]) => h("option", { value }, text)));
  made.addEventListener("change", () => action(made.value));
  return made;
}

export interface Key {
  keys: string[]; // as KeyboardEvent has them
  shown: string;
  about: string;
  action: (event: KeyboardEvent) => void;
}

/** Whether the focused element, or the browser, uses the key itself. */
function is_taken(event: KeyboardEvent): boolean {
  const { target, key } = event;
  if (event.ctrlKey || event.metaKey || event.altKey) return true;
  if (target instanceof HTMLSelectElement) return true;
  if (target instanceof HTMLInputElement && target.type === "range") return /^(Arrow|Home|End|Page)/.test(key);
  const pressed = target instanceof HTMLButtonElement || target instanceof HTMLInputElement || (target instanceof Element && target.tagName === "SUMMARY");
  return pressed && (key === " " || key === "Enter");
}

export function listen(element: HTMLElement, keys: Key[]): void {
  element.addEventListener("keydown", (event) => {
    if (is_taken(event)) return;
    const found = keys.find(({ keys }) => keys.includes(event.key) || keys.includes(event.key.toLowerCase()));
    if (!found) return;
    event.preventDefault();
    found.action(event);
  });
}

export function help(keys: Key[]): HTMLDetailsElement {
  const rows = keys.map(({ shown, about }) => h("div", {}, h("dt", {}, ...shown.split(" ").map((key) => h("kbd", {}, key))), h("dd", {}, about)));
  return h(
    "details",
    { class: "keys" },
    h("summary", {}, "Keys and symbols"),
    h("p", {}, "Drag to move the picture and double-click to zoom in; after a click, the wheel zooms too. Click a chart to go to its time. Each engine has the same shape on its bodies as on its lines in the charts."),
    h("dl", {}, ...rows),
  );
}

const parts = ["linear", "rotational", "potential"] as const;

/** The energy of each engine as a bar of three parts, scaled to those that are shown. */
export class Bars {
  readonly element: HTMLElement;
  private readonly rows: { film: Film; row: HTMLElement; segments: HTMLElement[]; sum: HTMLElement }[];

  constructor(films: Film[]) {
    this.rows = films.map((film) => {
      const segments = parts.map((part) => h("i", { class: part, style: `background-color: ${film.engine.color}` }));
      const sum = h("span", { class: "sum" });
      const row = h("div", { class: "bar" }, h("span", {}, film.engine.label), h("span", { class: "track", "aria-hidden": "true" }, ...segments), sum);
      return { film, row, segments, sum };
    });
    const key = h("p", { class: "key" }, ...parts.flatMap((part) => [h("i", { class: part }), part]), " (drawn from its lowest)");
    this.element = h("div", { class: "bars" }, h("strong", {}, "Energy"), ...this.rows.map(({ row }) => row), key);
  }

  show(films: Film[]): void {
    const floor = Math.min(...films.map(({ energy_range }) => energy_range.floor));
    const span = Math.max(...films.map(({ energy_range }) => energy_range.top)) - floor || 1;
    for (const { film, row, segments, sum } of this.rows) {
      row.hidden = !films.includes(film);
      if (row.hidden) continue;
      const { linear, rotational, potential } = film.energy();
      const drawn = [linear, rotational, potential - floor];
      segments.forEach((segment, k) => (segment.style.width = `${(100 * Math.max(0, drawn[k] ?? 0)) / span}%`));
      sum.textContent = number(linear + rotational + potential, "J");
    }
  }
}
