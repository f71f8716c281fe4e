// What the keyboard does, and the list that tells of it.
import { h } from "../dom";

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
