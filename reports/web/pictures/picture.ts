// One figure as an SVG file that stands alone: its title, its charts, who is who, and the page's colours for light and
// dark, so that a README can show it.

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
