// A chart with its title and a sentence on what it shows. It is drawn when it comes near the screen, and redrawn when
// its width changes.
import { h } from "../dom";

export interface Figure {
  title: string;
  note?: string | undefined;
  height: number; // px, approximately; reserved until the chart is drawn
  draw: (width: number) => Element[];
}

const paper_width = 640; // px

const pending = new Map<Element, (width: number) => void>();

const waiting = new Map<Element, () => void>();

const near = new IntersectionObserver(
  (entries) => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      near.unobserve(target);
      waiting.get(target)?.();
      waiting.delete(target);
    }
  },
  { rootMargin: "600px" },
);

/** Calls back once, when an element comes near the screen. */
export function when_near(element: Element, callback: () => void): void {
  waiting.set(element, callback);
  near.observe(element);
}

const resized = new ResizeObserver((entries) => {
  for (const { target, contentRect } of entries) {
    if (contentRect.width > 0) pending.get(target)?.(Math.floor(contentRect.width));
  }
});

/** Draws all charts at the width of a printed page. */
export function draw_all(): void {
  for (const [canvas, draw] of pending) {
    if (canvas.isConnected) draw(paper_width);
    else pending.delete(canvas);
  }
}

/** For screen readers the drawing is one image with a name; tables have its numbers. */
function fill(canvas: HTMLElement, charts: Element[], name: string): void {
  for (const chart of charts) chart.setAttribute("aria-hidden", "true");
  if (charts.length) canvas.setAttribute("role", "img");
  if (charts.length) canvas.setAttribute("aria-label", name);
  canvas.replaceChildren(...charts);
}

export function figure({ title, note, height, draw }: Figure): HTMLElement {
  const canvas = h("div", { class: "canvas", style: `min-height: ${height}px` });
  let drawn = 0;
  pending.set(canvas, (width) => {
    if (width === drawn) return;
    drawn = width;
    canvas.style.minHeight = "";
    fill(canvas, draw(width), [title, note].filter(Boolean).join(". "));
  });
  when_near(canvas, () => resized.observe(canvas));
  return h("figure", {}, h("figcaption", {}, h("strong", {}, title), note ? h("span", {}, note) : null), canvas);
}
