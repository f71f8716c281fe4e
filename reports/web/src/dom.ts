// Creates elements. Children that are strings become text nodes, never markup.

export type Child = Node | string | null | undefined | false;

export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, string | undefined> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const name in attributes) {
    const value = attributes[name];
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

/** A table; on narrow screens its rows become cards, whose cells show their data-label. */
export function table(caption: string, heads: (string | Node)[], rows: HTMLTableRowElement[], kind = ""): HTMLElement {
  const head = h("tr", {}, ...heads.map((text) => h("th", { scope: "col" }, text)));
  return h(
    "div",
    { class: "table", tabindex: "0", role: "group", "aria-label": caption },
    h("table", { class: kind }, h("caption", {}, caption), h("thead", {}, head), h("tbody", {}, ...rows)),
  );
}

/** Prefixes every id inside an element, and every reference to one, so that ids stay unique on the page. */
export function prefixed<E extends Element>(prefix: string, element: E): E {
  for (const one of [element, ...element.querySelectorAll("*")]) {
    if (one.id) one.id = prefix + one.id;
    const href = one.getAttribute("href");
    if (href?.startsWith("#")) one.setAttribute("href", `#${prefix}${href.slice(1)}`);
    for (const name of ["aria-labelledby", "aria-describedby", "aria-controls", "for"]) {
      const ids = one.getAttribute(name);
      if (ids) one.setAttribute(name, ids.split(" ").map((id) => prefix + id).join(" "));
    }
  }
  return element;
}

/** Turns any text into an id. */
export function slug(...parts: string[]): string {
  return parts.map((part) => encodeURIComponent(part.trim().toLowerCase().replace(/\s+/g, "-"))).join("--");
}
