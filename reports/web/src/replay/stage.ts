// The canvas: its size, its panes, and how the pointer moves the camera.
import { scale as type_scale } from "../charts/look";
import { h } from "../dom";
import { Camera, View, type Bounds, type Pane } from "./camera";
import type { Film } from "./film";
import type { Figures } from "./outline";
import { paint, type Picture, type Shown } from "./paint";

export interface Showing extends Shown {
  films: Film[]; // including the truth
  side_by_side: boolean; // rather than on top of each other
  ring: Picture["ring"];
}

const least_pane = 200; // px wide
const name_height = 28; // px, at the usual size of type

/** As few rows as fit, each as full as the others can be. */
function grid(count: number, width: number, height: number, head: number): Pane[] {
  const most = Math.max(1, Math.floor(width / least_pane));
  const rows = Math.ceil(count / most);
  const columns = Math.ceil(count / rows);
  return Array.from({ length: count }, (_, i) => ({
    x: ((i % columns) * width) / columns,
    y: (Math.floor(i / columns) * height) / rows,
    width: width / columns,
    height: height / rows,
    head,
  }));
}

/** The bounds of the moving bodies over the whole film. */
export function bounds_of(film: Film, figures: Figures): Bounds {
  const bounds = { left: Infinity, bottom: Infinity, right: -Infinity, top: -Infinity };
  film.each_position((body, x, y) => {
    const radius = figures.radius(body);
    if (figures.scene.bodies[body]?.type === "fixed" || !Number.isFinite(radius)) return;
    bounds.left = Math.min(bounds.left, x - radius);
    bounds.right = Math.max(bounds.right, x + radius);
    bounds.bottom = Math.min(bounds.bottom, y - radius);
    bounds.top = Math.max(bounds.top, y + radius);
  });
  if (!(bounds.right > bounds.left)) return { left: -1, bottom: -1, right: 1, top: 1 };
  // Motion along a line still needs some height or width.
  const least = 0.2 * Math.max(bounds.right - bounds.left, bounds.top - bounds.bottom);
  const padding_x = Math.max(0, least - (bounds.right - bounds.left)) / 2;
  const padding_y = Math.max(0, least - (bounds.top - bounds.bottom)) / 2;
  return { left: bounds.left - padding_x, right: bounds.right + padding_x, bottom: bounds.bottom - padding_y, top: bounds.top + padding_y };
}

export class Stage {
  readonly canvas = h("canvas", { tabindex: "0", role: "img" });
  private readonly camera: Camera;
  private readonly colors = new Map<string, string>();
  private readonly largest: number;
  private panes: Pane[] = [];
  private scheduled = false;

  constructor(
    private readonly figures: Figures,
    films: Film[],
    bounds: Bounds,
    private readonly showing: () => Showing,
  ) {
    this.camera = new Camera(bounds);
    this.largest = Math.max(0, ...films.map((film) => film.largest_impulse()));
    new ResizeObserver(() => this.resize()).observe(this.canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.repaint());
    matchMedia("print").addEventListener("change", () => this.repaint());
    this.listen();
  }

  private repaint(): void {
    this.colors.clear();
    this.draw();
  }

  private readonly color = (variable: string): string => {
    let found = this.colors.get(variable);
    if (found === undefined) {
      const name = /^var\((.*)\)$/.exec(variable)?.[1] ?? "";
      found = getComputedStyle(document.documentElement).getPropertyValue(name).trim() || "gray";
      this.colors.set(variable, found);
    }
    return found;
  };

  private resize(): void {
    const ratio = devicePixelRatio;
    const width = Math.round(this.canvas.clientWidth * ratio);
    const height = Math.round(this.canvas.clientHeight * ratio);
    if (!width || (width === this.canvas.width && height === this.canvas.height)) return;
    this.canvas.width = width;
    this.canvas.height = height;
    this.paint();
  }

  /** Paints at the next frame, once. */
  draw(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      this.paint();
    });
  }

  private paint(): void {
    const context = this.canvas.getContext("2d");
    if (!context || !this.canvas.width) return;
    const { films, side_by_side, ring, ...shown } = this.showing();
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    const truths = films.filter(({ engine }) => engine.exact);
    const engines = films.filter(({ engine }) => !engine.exact);
    const split = side_by_side && engines.length > 1;
    const parts = split ? engines.map((film) => [...truths, film]) : [films];
    this.panes = grid(parts.length, width, height, split ? name_height * type_scale() : 0);
    context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    context.clearRect(0, 0, width, height);
    context.font = `${13 * type_scale()}px ${getComputedStyle(this.canvas).fontFamily}`;
    parts.forEach((part, index) => {
      const pane = this.panes[index];
      if (!pane) return;
      paint(context, new View(pane, this.camera), { figures: this.figures, films: part, named: split, shown, largest: this.largest, ring }, this.color);
      if (index === 0) this.expose_view(new View(pane, this.camera));
    });
    this.draw_borders(context);
  }

  /** For tests: px per m and the origin of the first pane, px. */
  private expose_view(view: View): void {
    this.canvas.dataset["view"] = [view.scale, view.x(0), view.y(0)].join(" ");
  }

  private draw_borders(context: CanvasRenderingContext2D): void {
    context.strokeStyle = this.color("var(--hair)");
    context.lineWidth = 1;
    for (const { x, y, width, height } of this.panes.length > 1 ? this.panes : []) context.strokeRect(x, y, width, height);
  }

  zoom_by(factor: number): void {
    this.camera.zoom_by(factor, this.pane_at(0, 0));
    this.draw();
  }

  /** By fractions of the pane. */
  pan(x: number, y: number): void {
    const pane = this.pane_at(0, 0);
    this.camera.pan(x * pane.width, y * pane.height, pane);
    this.draw();
  }

  fit(): void {
    this.camera.fit();
    this.draw();
  }

  private pane_at(x: number, y: number): Pane {
    const whole = { x: 0, y: 0, width: this.canvas.clientWidth, height: this.canvas.clientHeight, head: 0 };
    return this.panes.find((pane) => x >= pane.x && x < pane.x + pane.width && y >= pane.y && y < pane.y + pane.height) ?? whole;
  }

  private listen(): void {
    const { canvas } = this;
    canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("pointermove", (event) => {
      if (!canvas.hasPointerCapture(event.pointerId)) return;
      this.camera.pan(event.movementX, event.movementY, this.pane_at(event.offsetX, event.offsetY));
      this.draw();
    });
    // The wheel scrolls the page unless the canvas has the focus.
    canvas.addEventListener(
      "wheel",
      (event) => {
        if (!event.ctrlKey && document.activeElement !== canvas) return;
        event.preventDefault();
        this.camera.zoom_by(2 ** (-event.deltaY / 250), this.pane_at(event.offsetX, event.offsetY), event.offsetX, event.offsetY);
        this.draw();
      },
      { passive: false },
    );
    canvas.addEventListener("dblclick", (event) => {
      this.camera.zoom_by(2, this.pane_at(event.offsetX, event.offsetY), event.offsetX, event.offsetY);
      this.draw();
    });
  }
}
