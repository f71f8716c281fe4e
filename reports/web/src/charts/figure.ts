// A chart with its title and one sentence on what it shows. Drawn when it comes near the screen, at the width it has
// there, and again when that changes.
import { h } from "../dom";

export interface Figure {
  title: string;
  note?: string | undefined;
  height: number; // px, about; keeps the place until it is drawn
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

/** Acts once, when an element comes near the screen. */
export function when_near(element: Element, act: () => void): void {
  waiting.set(element, act);
  near.observe(element);
}

const resized = new ResizeObserver((entries) => {
  for (const { target, contentRect } of entries) {
    if (contentRect.width > 0) pending.get(target)?.(Math.floor(contentRect.width));
  }
});

/** For paper, at a width of its own. */
export function draw_all(): void {
  for (const [canvas, draw] of pending) {
    if (canvas.isConnected) draw(paper_width);
    else pending.delete(canvas);
  }
}

/** To a screen reader what is drawn is one picture with a name; tables hold its numbers. */
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
