// Saves every chart of a page as an SVG file, without a browser:
//
//   node pictures.cjs PAGE.html FOLDER
//
// The page draws itself as it does for print, in a document without layout, so a picture is the same as the page's chart.
import { mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { join } from "node:path";
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

export interface Picture {
  name: string; // of the file
  text: string;
}

const pad = 16;
const line = 20;
const per_letter = 7; // px, about, at 13 px

const escaped = (text: string): string => text.replace(/[&<>"]/g, (letter) => `&#${letter.charCodeAt(0)};`);
const text_of = (element: Element | null | undefined): string => element?.textContent?.trim() ?? "";
const size_of = (chart: Element, side: "width" | "height"): number => Number(chart.getAttribute(side)) || 0;

/** "Study: speed, bounce, e=0.8" */
function place_of(figure: Element): string[] {
  const places: string[] = [];
  for (let one: Element | null = figure.closest("section, article"); one; one = one.parentElement?.closest("section, article") ?? null) {
    const title = text_of([...one.children].find(({ tagName }) => /^H[23]$/i.test(tagName)));
    if (title) places.unshift(title);
  }
  return places;
}

const file_name = (parts: string[]): string =>
  parts
    .map((part) => part.toLowerCase().replace(/[^a-z0-9.=+-]+/g, "-").replace(/^-+|-+$/g, ""))
    .filter(Boolean)
    .join("--");

/** At a place in the picture; nested, so that its own coordinates stay. */
function placed(chart: Element, x: number, y: number): string {
  const copy = chart.cloneNode(true) as Element;
  copy.setAttribute("x", String(x));
  copy.setAttribute("y", String(y));
  return copy.outerHTML;
}

/** The legend nearest before the figure: marks and names, in as many rows as they need. */
function legend_of(figure: Element, width: number, top: number): { text: string; height: number } {
  const near = figure.closest("article, section")?.querySelector(".legend:not(.fates)");
  const items = [...(near?.children ?? [])];
  let [x, y] = [pad, top];
  const text = items.map((item) => {
    const name = text_of(item.querySelector("span"));
    const needed = 42 + per_letter * name.length + 20;
    if (x > pad && x + needed > width - pad) [x, y] = [pad, y + line + 2];
    const mark = item.querySelector("svg");
    const shown = `${mark ? placed(mark, x, y) : ""}<text x="${x + 42}" y="${y + 13}">${escaped(name)}</text>`;
    x += needed;
    return shown;
  });
  return { text: text.join(""), height: items.length ? y - top + line + 8 : 0 };
}

export function picture(figure: Element, palette: string): Picture {
  const charts = [...figure.querySelectorAll(".canvas > svg")];
  const title = text_of(figure.querySelector("figcaption strong"));
  const about = text_of(figure.querySelector("figcaption span"));
  const places = place_of(figure);
  const width = Math.max(...charts.map((chart) => size_of(chart, "width"))) + 2 * pad;
  let y = pad + 2 * line + 8;
  const drawn = charts.map((chart) => {
    const shown = placed(chart, pad, y);
    y += size_of(chart, "height") + 8;
    return shown;
  });
  const legend = legend_of(figure, width, y);
  const height = y + legend.height + pad - 8;
  return {
    name: file_name([...places, title]),
    text: `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" role="img" aria-labelledby="title about">
<title id="title">${escaped([...places, title].join(", "))}</title>
<desc id="about">${escaped(about)}</desc>
<style>${palette}
svg{color:var(--soft);font:13px system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans",sans-serif}text{white-space:pre}</style>
<rect width="${width}" height="${height}" rx="10" fill="var(--card)"/>
<text x="${pad}" y="${pad + 14}" fill="var(--ink)" font-size="16" font-weight="600">${escaped(title)}</text>
<text x="${pad}" y="${pad + 14 + line}" fill="var(--soft)">${escaped(places.join(", "))}</text>
${drawn.join("\n")}
<g fill="var(--soft)">${legend.text}</g>
</svg>
`,
  };
}

function main([page, folder]: string[]): void {
  if (!page || !folder) throw new Error("PAGE.html and FOLDER are needed");
  const { figures, palette } = drawn(readFileSync(page, "utf8"));
  mkdirSync(folder, { recursive: true });
  const names = new Set<string>();
  for (const figure of figures) {
    const { name, text } = picture(figure, palette);
    const file = join(folder, `${name}${names.has(name) ? `-${names.size}` : ""}.svg`);
    names.add(name);
    writeFileSync(`${file}.part`, text);
    renameSync(`${file}.part`, file);
  }
  if (!names.size) throw new Error(`${page} has no charts`);
  console.log(`${figures.length} pictures in ${folder}`);
}

try {
  main(process.argv.slice(2));
} catch (error) {
  console.error((error as Error).message);
  process.exitCode = 1;
}
