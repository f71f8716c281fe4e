// A chart with its title and a sentence on what it shows. It is drawn when it comes near the screen, and redrawn when
// its width changes.
import { h } from "../dom";

export interface Figure {
  title: string;
  note?: string | undefined;
  height: number; // px, approximately; reserved until the chart is drawn
  log?: boolean; // whether the chart starts with a logarithmic axis; left out if readers cannot choose
  draw: (width: number, log: boolean) => Element[];
}

const paper_width = 640; // px

const pending = new Map<Element, (width: number, anew?: boolean) => void>();

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

/** Draws all charts again, those far from the screen later: other engines are chosen. */
export function redraw(): void {
  for (const [canvas, draw] of pending) {
    if (!canvas.isConnected) pending.delete(canvas);
    else if (canvas.childElementCount) when_near(canvas, () => draw(Math.floor(canvas.clientWidth), true));
  }
}

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

/** Switches between a linear and a logarithmic axis. */
function scale_button(title: string, log: boolean, change: (log: boolean) => void): HTMLElement {
  let now = log;
  const button = h("button", { type: "button", class: "scale", "aria-pressed": String(now), "aria-label": `log axis: ${title}` }, "log");
  button.addEventListener("click", () => {
    now = !now;
    button.setAttribute("aria-pressed", String(now));
    change(now);
  });
  return button;
}

export function figure({ title, note, height, log, draw }: Figure): HTMLElement {
  const canvas = h("div", { class: "canvas", style: `min-height: ${height}px` });
  let drawn = 0;
  let logarithmic = log ?? false;
  pending.set(canvas, (width, anew = false) => {
    if (width === drawn && !anew) return;
    drawn = width;
    canvas.style.minHeight = "";
    fill(canvas, draw(width, logarithmic), [title, note].filter(Boolean).join(". "));
  });
  const change = (to: boolean): void => {
    logarithmic = to;
    if (drawn) pending.get(canvas)?.(drawn, true);
  };
  when_near(canvas, () => resized.observe(canvas));
  return h("figure", {}, h("figcaption", {}, log === undefined ? null : scale_button(title, log, change), h("strong", {}, title), note ? h("span", {}, note) : null), canvas);
}
