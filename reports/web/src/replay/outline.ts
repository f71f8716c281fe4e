// The outlines of bodies as canvas paths in pixels. Bodies of the same look share a path.
import type { View } from "./camera";
import type { Outline, Scene } from "./data";
import type { Film } from "./film";

interface Figure {
  outlines: Outline[];
  radius: number; // m, of the bounding disc around the centre of mass; infinite for a half-space
}

const radius_of = (outline: Outline): number =>
  outline.points ? Math.max(...outline.points.map(([x, y]) => Math.hypot(x, y))) + (outline.radius ?? 0) : Infinity;

/** Discs of at least this radius have a spoke that shows their rotation. */
const least_spoke = 5; // px

function disc(path: Path2D, x: number, y: number, radius: number, cos: number, sin: number): void {
  path.moveTo(x + radius, y);
  path.arc(x, y, radius, 0, 2 * Math.PI);
  if (radius < least_spoke) return;
  path.moveTo(x, y);
  path.lineTo(x + radius * cos, y - radius * sin);
}

function capsule(path: Path2D, ax: number, ay: number, bx: number, by: number, radius: number): void {
  const along = Math.atan2(by - ay, bx - ax);
  path.moveTo(ax + radius * Math.cos(along + Math.PI / 2), ay + radius * Math.sin(along + Math.PI / 2));
  path.arc(ax, ay, radius, along + Math.PI / 2, along - Math.PI / 2);
  path.arc(bx, by, radius, along - Math.PI / 2, along + Math.PI / 2);
  path.closePath();
}

/** A polygon that covers the part of the half-space inside the pane. */
function half_space(path: Path2D, view: View, x: number, y: number, nx: number, ny: number, offset: number): void {
  const { pane, scale } = view;
  const reach = 2 * (pane.width + pane.height);
  const middle_x = pane.x + pane.width / 2;
  const middle_y = pane.y + pane.height / 2;
  // Height of the pane's middle above the boundary, px. The normal's y points up, the screen's down.
  const above = (middle_x - x) * nx - (middle_y - y) * ny - offset * scale;
  const foot_x = middle_x - above * nx;
  const foot_y = middle_y + above * ny;
  const depth = reach + Math.abs(above);
  path.moveTo(foot_x - ny * reach, foot_y - nx * reach);
  path.lineTo(foot_x + ny * reach, foot_y + nx * reach);
  path.lineTo(foot_x + ny * reach - nx * depth, foot_y + nx * reach + ny * depth);
  path.lineTo(foot_x - ny * reach - nx * depth, foot_y - nx * reach + ny * depth);
  path.closePath();
}

export class Figures {
  private readonly figures: Figure[];

  constructor(readonly scene: Scene) {
    this.figures = scene.bodies.map(({ outlines }) => {
      const own = outlines.flatMap((index) => scene.outlines[index] ?? []);
      return { outlines: own, radius: Math.max(0, ...own.map(radius_of)) };
    });
  }

  /** m, of the bounding disc */
  radius(body: number): number {
    return this.figures[body]?.radius ?? 0;
  }

  /** The wanted bodies of a film that may be visible now. */
  in_view(view: View, film: Film, wanted: (body: number) => boolean): number[] {
    const found: number[] = [];
    this.figures.forEach(({ radius }, body) => {
      if (!wanted(body)) return;
      const x = view.x(film.now[body * 3] ?? 0);
      const y = view.y(film.now[body * 3 + 1] ?? 0);
      if (view.holds(x, y, radius * view.scale)) found.push(body);
    });
    return found;
  }

  /** Adds a body to a path, in its current pose and shrunk by `inset` px. */
  add(path: Path2D, view: View, film: Film, body: number, inset = 0): void {
    const figure = this.figures[body];
    if (!figure) return;
    const x = view.x(film.now[body * 3] ?? 0);
    const y = view.y(film.now[body * 3 + 1] ?? 0);
    const angle = film.now[body * 3 + 2] ?? 0;
    const scale = view.scale * Math.max(0.5, 1 - inset / (figure.radius * view.scale));
    const cos = Math.cos(angle);
    const sin = Math.sin(angle);
    for (const outline of figure.outlines) add_outline(path, view, outline, { x, y, cos, sin, scale });
  }
}

interface Placed {
  x: number; // px, of the centre of mass
  y: number;
  cos: number; // of the angle
  sin: number;
  scale: number; // px per m
}

function add_outline(path: Path2D, view: View, outline: Outline, { x, y, cos, sin, scale }: Placed): void {
  const { points, radius = 0, normal, offset = 0 } = outline;
  if (!points) {
    const [nx, ny] = normal ?? [0, 1];
    half_space(path, view, x, y, nx * cos - ny * sin, nx * sin + ny * cos, offset);
    return;
  }
  const at_x = (k: number): number => x + ((points[k]?.[0] ?? 0) * cos - (points[k]?.[1] ?? 0) * sin) * scale;
  const at_y = (k: number): number => y - ((points[k]?.[0] ?? 0) * sin + (points[k]?.[1] ?? 0) * cos) * scale;
  if (points.length === 1) {
    disc(path, at_x(0), at_y(0), radius * scale, cos, sin);
  } else if (points.length === 2 && radius > 0) {
    capsule(path, at_x(0), at_y(0), at_x(1), at_y(1), radius * scale);
  } else {
    path.moveTo(at_x(0), at_y(0));
    for (let k = 1; k < points.length; ++k) path.lineTo(at_x(k), at_y(k));
    if (points.length > 2) path.closePath();
  }
}
