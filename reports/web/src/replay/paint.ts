// Draws a pane: static bodies, the truth as a ghost, the engines on top of it, and optionally contacts and velocities.
import { shape_of } from "../charts/look";
import { given } from "../format";
import type { View } from "./camera";
import type { Joint } from "./data";
import type { Film } from "./film";
import type { Figures } from "./outline";

export interface Shown {
  contacts: boolean;
  velocities: boolean;
}

/** Resolves a CSS variable, which a canvas cannot. */
export type Color = (variable: string) => string;

/** With more bodies in view than this, bodies have no lines, which are expensive, but gaps between their fills. */
const most_outlined = 1000;
const gap = 0.6; // px, by which their outlines shrink
/** Bodies in one path: the cost of a path grows faster than its length. */
const path_length = 60;
/** More joints than this have no marks at their ends. */
const most_marked_joints = 300;
const longest_arrow = 60; // px, of the largest impulse
const velocity_time = 0.1; // s; an arrow is the displacement in this time
const least_arrow = 3; // px

/** Returns the bodies that were drawn. `layers` engines are drawn on top of each other; their fills share one opacity. */
function bodies(context: CanvasRenderingContext2D, figures: Figures, view: View, film: Film, layers: number, color: Color): number[] {
  const { engine } = film;
  const shown = figures.in_view(view, film, (body) => figures.scene.bodies[body]?.type !== "fixed");
  const filled = shown.length > most_outlined;
  const ink = color(engine.color);
  context.save();
  context.lineJoin = "round";
  context.strokeStyle = ink;
  context.fillStyle = ink;
  context.lineWidth = engine.exact ? 5 : 1.75;
  if (engine.dash && !engine.exact) context.setLineDash(engine.dash.split(" ").map(Number));
  for (let start = 0; start < shown.length; start += path_length) {
    const path = new Path2D();
    for (const body of shown.slice(start, start + path_length)) figures.add(path, view, film, body, filled ? gap : 0);
    context.globalAlpha = engine.exact ? 0.6 : (filled ? 0.75 : 0.16) / layers;
    context.fill(path);
    context.globalAlpha = 1;
    if (!filled) context.stroke(path);
  }
  context.restore();
  return shown;
}

function static_bodies(context: CanvasRenderingContext2D, figures: Figures, view: View, film: Film, color: Color): void {
  const path = new Path2D();
  for (const body of figures.in_view(view, film, (body) => figures.scene.bodies[body]?.type === "fixed")) figures.add(path, view, film, body);
  context.fillStyle = color("var(--quiet-wash)");
  context.fill(path);
  context.strokeStyle = color("var(--faint)");
  context.lineWidth = 1;
  context.stroke(path);
}

function anchor(film: Film, body: number | null, [x, y]: [number, number]): [number, number] {
  if (body === null) return [x, y];
  const angle = film.now[body * 3 + 2] ?? 0;
  const cos = Math.cos(angle);
  const sin = Math.sin(angle);
  return [(film.now[body * 3] ?? 0) + x * cos - y * sin, (film.now[body * 3 + 1] ?? 0) + x * sin + y * cos];
}

function joints(context: CanvasRenderingContext2D, all: Joint[], view: View, film: Film, color: Color): void {
  const path = new Path2D();
  const end = (x: number, y: number): void => {
    path.moveTo(x + 2, y);
    path.arc(x, y, 2, 0, 2 * Math.PI);
  };
  for (const { a, b, at_a, at_b } of all) {
    const [ax, ay] = anchor(film, a, at_a);
    const [bx, by] = anchor(film, b, at_b);
    path.moveTo(view.x(ax), view.y(ay));
    path.lineTo(view.x(bx), view.y(by));
    if (all.length > most_marked_joints) continue;
    end(view.x(ax), view.y(ay));
    end(view.x(bx), view.y(by));
  }
  context.strokeStyle = color(film.engine.color);
  context.lineWidth = 1.25;
  context.stroke(path);
}

function arrow(path: Path2D, x: number, y: number, dx: number, dy: number): void {
  const size = Math.hypot(dx, dy);
  if (size < least_arrow) return;
  const head = Math.min(6, size / 2) / size;
  const [bx, by] = [x + dx, y + dy];
  path.moveTo(x, y);
  path.lineTo(bx, by);
  path.moveTo(bx - head * (dx - dy / 2), by - head * (dy + dx / 2));
  path.lineTo(bx, by);
  path.lineTo(bx - head * (dx + dy / 2), by - head * (dy - dx / 2));
}

function velocities(context: CanvasRenderingContext2D, figures: Figures, view: View, film: Film, color: Color): void {
  const path = new Path2D();
  const reach = velocity_time * view.scale;
  figures.scene.bodies.forEach(({ type }, body) => {
    if (type === "fixed") return;
    const x = view.x(film.now[body * 3] ?? 0);
    const y = view.y(film.now[body * 3 + 1] ?? 0);
    arrow(path, x, y, reach * (film.velocity[body * 2] ?? 0), -reach * (film.velocity[body * 2 + 1] ?? 0));
  });
  context.strokeStyle = color(film.engine.color);
  context.lineWidth = 1.5;
  context.stroke(path);
}

function contacts(context: CanvasRenderingContext2D, view: View, film: Film, largest: number, color: Color): void {
  const found = film.contacts();
  if (!found) return;
  const points = new Path2D();
  const arrows = new Path2D();
  const reach = largest > 0 ? longest_arrow / largest : 0;
  for (let i = 0; i < found.length; i += 4) {
    const x = view.x(found[i] ?? 0);
    const y = view.y(found[i + 1] ?? 0);
    points.moveTo(x + 2.5, y);
    points.arc(x, y, 2.5, 0, 2 * Math.PI);
    arrow(arrows, x, y, reach * (found[i + 2] ?? 0), -reach * (found[i + 3] ?? 0));
  }
  context.fillStyle = color(film.engine.color);
  context.strokeStyle = color(film.engine.color);
  context.lineWidth = 1.5;
  context.stroke(arrows);
  context.fill(points);
}

/** A round length of about 80 px. */
function scale_bar(context: CanvasRenderingContext2D, view: View, color: Color): void {
  const { pane, scale } = view;
  const unit = 10 ** Math.floor(Math.log10(80 / scale));
  const metres = [5, 2, 1].find((many) => many * unit * scale <= 100) ?? 1;
  const [x, y] = [pane.x + 12, pane.y + pane.height - 10];
  const width = metres * unit * scale;
  context.strokeStyle = color("var(--soft)");
  context.fillStyle = color("var(--soft)");
  context.lineWidth = 1.25;
  context.beginPath();
  context.moveTo(x, y - 4);
  context.lineTo(x, y);
  context.lineTo(x + width, y);
  context.lineTo(x + width, y - 4);
  context.stroke();
  context.textAlign = "left";
  context.textBaseline = "bottom";
  context.fillText(given(Number((metres * unit).toPrecision(1)), "m"), x + 4, y - 2);
}

const most_marked = 24; // bodies; more marks would hide them
/** Up to this number of bodies, each has the marks of all engines around its centre; otherwise of one engine in turn. */
const most_with_all_marks = 6;
const mark_offset = 9; // px from the centre

const shapes = new Map<string, Path2D>();

function draw_shape(context: CanvasRenderingContext2D, { engine }: Film, x: number, y: number, color: Color): void {
  const shape = shapes.get(engine.symbol) ?? new Path2D(shape_of(engine));
  shapes.set(engine.symbol, shape);
  context.save();
  context.translate(x, y);
  context.fillStyle = color(engine.color);
  context.strokeStyle = color("var(--paper)");
  context.lineWidth = 2;
  context.stroke(shape);
  context.fill(shape);
  context.restore();
}

/**
 * The engine's shape on some of its bodies, because colour alone does not distinguish engines.
 * `seen`: its bodies in view; `index`: of the engine among all `engines`.
 */
function marks(context: CanvasRenderingContext2D, view: View, film: Film, seen: number[], index: number, engines: number, color: Color): void {
  // A power of two, so that bodies that enter or leave the view hardly change which bodies are marked.
  const every = 2 ** Math.max(0, Math.ceil(Math.log2(seen.length / most_marked)));
  const together = seen.length <= most_with_all_marks;
  const angle = (2 * Math.PI * index) / engines - Math.PI / 2;
  const off = together && engines > 1 ? mark_offset : 0;
  for (const body of seen) {
    if (body % every || !(together || (body / every) % engines === index)) continue;
    const x = view.x(film.now[body * 3] ?? 0) + off * Math.cos(angle);
    const y = view.y(film.now[body * 3 + 1] ?? 0) + off * Math.sin(angle);
    draw_shape(context, film, x, y, color);
  }
}

export interface Picture {
  figures: Figures;
  films: Film[]; // shown in this pane, including the truth
  named: boolean; // whether the pane shows the name of its engine
  shown: Shown;
  largest: number; // N s, over all impulses of the case
  ring: { film: Film; body: number } | undefined;
}

function ring(context: CanvasRenderingContext2D, view: View, { figures }: Picture, film: Film, body: number, color: Color): void {
  const size = figures.radius(body);
  const radius = Math.max(10, (Number.isFinite(size) ? size : 0) * view.scale + 5);
  context.strokeStyle = color("var(--wrong)");
  context.lineWidth = 2;
  context.beginPath();
  context.arc(view.x(film.now[body * 3] ?? 0), view.y(film.now[body * 3 + 1] ?? 0), radius, 0, 2 * Math.PI);
  context.stroke();
}

function name_pane(context: CanvasRenderingContext2D, { pane }: View, film: Film, color: Color): void {
  context.fillStyle = color("var(--ink)");
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.fillText(film.engine.label, pane.x + 26, pane.y + 16);
  draw_shape(context, film, pane.x + 15, pane.y + 16, color);
}

export function paint(context: CanvasRenderingContext2D, view: View, picture: Picture, color: Color): void {
  const { figures, films, named, shown } = picture;
  const { pane } = view;
  context.save();
  context.beginPath();
  context.rect(pane.x, pane.y, pane.width, pane.height);
  context.clip();
  const engines = films.filter(({ engine }) => !engine.exact);
  const seen = new Map<Film, number[]>();
  const [first] = films;
  if (first) static_bodies(context, figures, view, first, color);
  for (const film of [...films].sort((a, b) => Number(b.engine.exact) - Number(a.engine.exact))) {
    seen.set(film, bodies(context, figures, view, film, Math.max(1, engines.length), color));
    joints(context, figures.scene.joints, view, film, color);
    if (film.engine.exact) continue;
    if (shown.contacts) contacts(context, view, film, picture.largest, color);
    if (shown.velocities) velocities(context, figures, view, film, color);
  }
  engines.forEach((film, index) => marks(context, view, film, seen.get(film) ?? [], index, engines.length, color));
  if (picture.ring && films.includes(picture.ring.film)) ring(context, view, picture, picture.ring.film, picture.ring.body, color);
  scale_bar(context, view, color);
  const [owner] = engines;
  if (named && owner) name_pane(context, view, owner, color);
  context.restore();
}
