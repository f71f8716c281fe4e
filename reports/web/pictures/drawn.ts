// A page's figures after it drew itself, in a document without layout.
import { runInThisContext } from "node:vm";
import { parseHTML } from "linkedom";

export interface Drawn {
  figures: Element[];
  palette: string; // CSS: the page's colours, light and dark
}

/** What the page asks of a browser beside its document: nothing ever comes near, changes its size, or is opened. */
class Watcher {
  observe(): void {}
  unobserve(): void {}
  disconnect(): void {}
}

const light = /:root\{(?=[^}]*--)[^}]*\}/;
const dark = /@media screen and \(prefers-color-scheme: ?dark\)\{:root\{[^}]*\}/;

function palette_of(style: string): string {
  const [found] = dark.exec(style) ?? [];
  return `${light.exec(style)?.[0] ?? ""}${found ? `${found}}` : ""}`;
}

export function drawn(html: string): Drawn {
  const { document, window } = parseHTML(html);
  const scripts = [...document.querySelectorAll("script:not([type])")];
  const told = new Map<string, (() => void)[]>();
  const browser = {
    document,
    window: globalThis,
    self: globalThis,
    IntersectionObserver: Watcher,
    ResizeObserver: Watcher,
    MutationObserver: Watcher,
    location: { hash: "" },
    getComputedStyle: () => ({ fontSize: "16px", getPropertyValue: () => "" }),
    matchMedia: () => ({ matches: false, addEventListener: () => {} }),
    addEventListener: (event: string, act: () => void) => told.set(event, [...(told.get(event) ?? []), act]),
    ...Object.fromEntries(["Node", "Element", "HTMLElement", "SVGElement", "Event"].map((name) => [name, (window as never)[name]])),
  };
  for (const [name, value] of Object.entries(browser)) {
    Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
  }
  for (const script of scripts) runInThisContext(script.textContent ?? "");
  for (const act of told.get("beforeprint") ?? []) act();
  const figures = [...document.querySelectorAll("figure")].filter((figure) => figure.querySelector(".canvas svg"));
  return { figures, palette: palette_of(document.querySelector("style")?.textContent ?? "") };
}
