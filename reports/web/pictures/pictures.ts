// Saves every chart of a page as an SVG file, without a browser:
//
//   node pictures.cjs PAGE.html FOLDER
//
// The page draws itself as it does for print, in a document without layout, so a picture is the same as the page's chart.
import { mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { runInThisContext } from "node:vm";
import { parseHTML } from "linkedom";

type Colours = Map<string, string>; // by the name of a variable, "--ink"

interface Palette {
  light: Colours;
  dark: Colours;
}

interface DrawnPage {
  figures: Element[];
  palette: Palette;
}

/** Retitles the browser's observers: nothing comes near the screen, changes its size or is opened. */
class NoObserver {
  observe(): void {}
  unobserve(): void {}
  disconnect(): void {}
}

const light = /:root\{(?=[^}]*--)[^}]*\}/;
const dark = /@media screen and \(prefers-color-scheme: ?dark\)\{:root\{[^}]*\}/;

function palette_of(style: string): Palette {
  const colours = (block: RegExp): Colours => new Map([...(block.exec(style)?.[0] ?? "").matchAll(/(--[\w-]+): ?([^;}]+)/g)].map(([, name, value]) => [name ?? "", value ?? ""]));
  return { light: colours(light), dark: colours(dark) };
}

/**
 * The light colours in place of the variables, which programs that print don't know; a viewer in dark mode replaces each
 * by its dark one. They are in capitals, which tells them from colours that are the same in both modes.
 */
function coloured(svg: string, { light, dark }: Palette): string {
  const used = new Set<string>();
  const printed = (name: string): string => light.get(name)?.toUpperCase() ?? "currentColor";
  const text = svg.replace(/var\((--[\w-]+)\)/g, (_, name: string) => {
    used.add(name);
    return printed(name);
  });
  const darker = [...used].flatMap((name) => ["fill", "stroke", "color"].map((kind) => `[${kind}="${printed(name)}"]{${kind}:${dark.get(name)}}`));
  return text.replace("</style>", `@media screen and (prefers-color-scheme:dark){${darker.join("")}}</style>`);
}

/** Runs the page's scripts in a document without layout; returns its charts as they are for print. */
function drawn(html: string): DrawnPage {
  const { document, window } = parseHTML(html);
  const scripts = [...document.querySelectorAll("script:not([type])")];
  const listeners = new Map<string, (() => void)[]>();
  const browser = {
    document,
    window: globalThis,
    self: globalThis,
    IntersectionObserver: NoObserver,
    ResizeObserver: NoObserver,
    MutationObserver: NoObserver,
    location: { hash: "" },
    getComputedStyle: () => ({ fontSize: "16px", getPropertyValue: () => "" }),
    matchMedia: () => ({ matches: false, addEventListener: () => {} }),
    addEventListener: (event: string, listener: () => void) => listeners.set(event, [...(listeners.get(event) ?? []), listener]),
    ...Object.fromEntries(["Node", "Element", "HTMLElement", "SVGElement", "Event"].map((name) => [name, (window as never)[name]])),
  };
  for (const [name, value] of Object.entries(browser)) {
    Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
  }
  for (const script of scripts) runInThisContext(script.textContent ?? "");
  for (const listener of listeners.get("beforeprint") ?? []) listener();
  const figures = [...document.querySelectorAll("figure")].filter((figure) => figure.querySelector(".canvas svg"));
  return { figures, palette: palette_of(document.querySelector("style")?.textContent ?? "") };
}

interface Picture {
  name: string; // of the file
  text: string;
}

const pad = 16;
const line = 20;
const per_letter = 7; // px, approximately, at 13 px

const escaped = (text: string): string => text.replace(/[&<>"]/g, (letter) => `&#${letter.charCodeAt(0)};`);
const text_of = (element: Element | null | undefined): string => element?.textContent?.trim() ?? "";
const size_of = (chart: Element, side: "width" | "height"): number => Number(chart.getAttribute(side)) || 0;

/** The heading of a section or an article, which stands in its summary where it can be folded. */
function heading_of(part: Element): Element | undefined {
  const children = [...part.children].flatMap((child) => (/^DETAILS$/i.test(child.tagName) ? [...(child.querySelector("summary")?.children ?? [])] : [child]));
  return children.find(({ tagName }) => /^H[23]$/i.test(tagName));
}

/** ["Study: speed", "bounce, e=0.8"] */
function titles_around(figure: Element): string[] {
  const titles: string[] = [];
  for (let one: Element | null = figure.closest("section, article"); one; one = one.parentElement?.closest("section, article") ?? null) {
    const title = text_of(heading_of(one));
    if (title) titles.unshift(title);
  }
  return titles;
}

const file_name = (parts: string[]): string =>
  parts
    .map((part) => part.toLowerCase().replace(/[^a-z0-9.=+-]+/g, "-").replace(/^-+|-+$/g, ""))
    .filter(Boolean)
    .join("--");

/** A chart at a position in the picture; nested, so that it keeps its own coordinates. */
function placed(chart: Element, x: number, y: number): string {
  const copy = chart.cloneNode(true) as Element;
  copy.setAttribute("x", String(x));
  copy.setAttribute("y", String(y));
  return copy.outerHTML;
}

/** What a legend shows beside a name: the mark of a curve, or the colour and letter of a map's cells; "" of a button. */
function mark_of(item: Element, x: number, y: number): string {
  const mark = item.querySelector("svg");
  if (mark) return placed(mark, x, y);
  const cell = item.querySelector("i");
  const [, fill, ink] = /background: ([^;]+); color: ([^;]+)/.exec(cell?.getAttribute("style") ?? "") ?? [];
  if (!cell || !fill || !ink) return "";
  return `<rect x="${x + 10}" y="${y}" width="24" height="18" fill="${fill}"/><text x="${x + 22}" y="${y + 13}" text-anchor="middle" fill="${ink}">${escaped(text_of(cell))}</text>`;
}

const name_in = (item: Element): string => text_of(item.querySelector("span")) || (item.lastChild?.textContent ?? "").trim();

/** The legend of the figure's case or map: marks and names, in as many rows as they need. */
function legend_of(figure: Element, width: number, top: number): { text: string; height: number } {
  const near = figure.closest("article, section")?.querySelector(".legend");
  const items = [...(near?.children ?? [])].filter((item) => mark_of(item, 0, 0));
  let [x, y] = [pad, top];
  const text = items.map((item) => {
    const name = name_in(item);
    const needed = 42 + per_letter * name.length + 20;
    if (x > pad && x + needed > width - pad) [x, y] = [pad, y + line + 2];
    const shown = `${mark_of(item, x, y)}<text x="${x + 42}" y="${y + 13}">${escaped(name)}</text>`;
    x += needed;
    return shown;
  });
  return { text: text.join(""), height: items.length ? y - top + line + 8 : 0 };
}

/**
 * A figure as an SVG file that stands alone: its title, its charts, its legend, and the page's colours for light and dark.
 */
function picture(figure: Element, palette: Palette): Picture {
  const charts = [...figure.querySelectorAll(".canvas > svg")];
  const title = text_of(figure.querySelector("figcaption strong"));
  const about = text_of(figure.querySelector("figcaption span"));
  const titles = titles_around(figure);
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
    name: file_name([...titles, title]),
    text: coloured(
      `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" color="var(--soft)" role="img" aria-labelledby="title about">
<title id="title">${escaped([...titles, title].join(", "))}</title>
<desc id="about">${escaped(about)}</desc>
<style>svg{font:13px system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans",sans-serif}text{white-space:pre}</style>
<rect width="${width}" height="${height}" rx="10" fill="var(--card)"/>
<text x="${pad}" y="${pad + 14}" fill="var(--ink)" font-size="16" font-weight="600">${escaped(title)}</text>
<text x="${pad}" y="${pad + 14 + line}" fill="var(--soft)">${escaped(titles.join(", "))}</text>
${drawn.join("\n")}
<g fill="var(--soft)">${legend.text}</g>
</svg>
`,
      palette,
    ),
  };
}

function main([page, folder]: string[]): void {
  if (!page || !folder) throw new Error("PAGE.html and FOLDER are needed");
  const { figures, palette } = drawn(readFileSync(page, "utf8"));
  mkdirSync(folder, { recursive: true });
  const names = new Map<string, number>(); // how many pictures have that name
  for (const figure of figures) {
    const { name, text } = picture(figure, palette);
    const before = names.get(name) ?? 0;
    const file = join(folder, `${name}${before ? `-${before + 1}` : ""}.svg`);
    names.set(name, before + 1);
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
