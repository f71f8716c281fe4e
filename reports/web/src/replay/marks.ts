// Each engine's shape on some of its bodies, as its lines in charts carry it: colour alone does not tell engines apart.
import { shape_of } from "../charts/look";
import type { Film } from "./film";
import type { View } from "./outline";
import type { Color } from "./paint";

const most_marked = 24; // bodies: more would hide what they mark
/** Of as few, each has the shapes of all engines, around its centre; of more, engines mark them by turns. */
const few = 6;
const apart = 9; // px from the centre

const shapes = new Map<string, Path2D>();

export function draw_shape(context: CanvasRenderingContext2D, { engine }: Film, x: number, y: number, color: Color): void {
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

/** `seen`: a film's bodies in view; `turn`: the how-manieth of so many `engines` it is of. */
export function marks(context: CanvasRenderingContext2D, view: View, film: Film, seen: number[], turn: number, engines: number, color: Color): void {
  // In powers of two, so that bodies that come and go hardly change who is marked.
  const every = 2 ** Math.max(0, Math.ceil(Math.log2(seen.length / most_marked)));
  const together = seen.length <= few;
  const angle = (2 * Math.PI * turn) / engines - Math.PI / 2;
  const off = together && engines > 1 ? apart : 0;
  for (const body of seen) {
    if (body % every || !(together || (body / every) % engines === turn)) continue;
    const x = view.x(film.now[body * 3] ?? 0) + off * Math.cos(angle);
    const y = view.y(film.now[body * 3 + 1] ?? 0) + off * Math.sin(angle);
    draw_shape(context, film, x, y, color);
  }
}
