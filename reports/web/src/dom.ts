// Elements by function. Children that are strings become text nodes, never markup.

export type Child = Node | string | null | undefined | false;

export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, string | undefined> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== undefined) element.setAttribute(name, value);
  }
  for (const child of children) {
    if (child) element.append(child);
  }
  return element;
}

const svg_namespace = "http://www.w3.org/2000/svg";

export function svg(tag: string, attributes: Record<string, string | number>, ...children: SVGElement[]): SVGElement {
  const element = document.createElementNS(svg_namespace, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

/** A table whose cells carry their column's name, so that a narrow screen can stack them. */
export function table(caption: string, heads: (string | Node)[], rows: HTMLTableRowElement[], kind = ""): HTMLElement {
  const head = h("tr", {}, ...heads.map((text) => h("th", { scope: "col" }, text)));
  return h(
    "div",
    { class: "table", tabindex: "0", role: "region", "aria-label": caption },
    h("table", { class: kind }, h("caption", {}, caption), h("thead", {}, head), h("tbody", {}, ...rows)),
  );
}

/** An id that any text may become. */
export function slug(...parts: string[]): string {
  return parts.map((part) => encodeURIComponent(part.trim().toLowerCase().replace(/\s+/g, "-"))).join("--");
}
