// From metres with y up to pixels with y down: the camera, and the view through it in one pane.

export interface Bounds {
  left: number; // m, as are the others
  bottom: number;
  right: number;
  top: number;
}

/** A part of the canvas, px. */
export interface Pane {
  x: number;
  y: number;
  width: number;
  height: number;
  head: number; // of the height, for the name: nothing is placed there, though what is zoomed in may reach into it
}

const middle = ({ y, height, head }: Pane): number => y + head + (height - head) / 2;

const margin = 0.06; // of the pane, around the bounds
const most_zoom = 1000;

export class Camera {
  private zoom = 1;
  private shift_x = 0; // m
  private shift_y = 0;

  constructor(private readonly bounds: Bounds) {}

  /** px per m */
  scale(pane: Pane): number {
    const { left, bottom, right, top } = this.bounds;
    const used = 1 - 2 * margin;
    return this.zoom * Math.min((used * pane.width) / (right - left), (used * (pane.height - pane.head)) / (top - bottom));
  }

  /** m, the point in the middle of the pane */
  centre(): { x: number; y: number } {
    const { left, bottom, right, top } = this.bounds;
    return { x: (left + right) / 2 + this.shift_x, y: (bottom + top) / 2 + this.shift_y };
  }

  fit(): void {
    this.zoom = 1;
    this.shift_x = 0;
    this.shift_y = 0;
  }

  /** Moves the picture by px. */
  pan(x: number, y: number, pane: Pane): void {
    const scale = this.scale(pane);
    this.shift_x -= x / scale;
    this.shift_y += y / scale;
  }

  /** The point at (x, y) stays in place. */
  zoom_by(factor: number, pane: Pane, x = pane.x + pane.width / 2, y = middle(pane)): void {
    const right = x - pane.x - pane.width / 2;
    const down = y - middle(pane);
    const before = this.scale(pane);
    this.zoom = Math.min(most_zoom, Math.max(1 / 8, this.zoom * factor));
    const after = this.scale(pane);
    this.shift_x += right / before - right / after;
    this.shift_y -= down / before - down / after;
  }
}

/** The mapping from metres to the pixels of a pane. */
export class View {
  readonly scale: number; // px per m
  private readonly origin_x: number;
  private readonly origin_y: number;

  constructor(
    readonly pane: Pane,
    camera: Camera,
  ) {
    this.scale = camera.scale(pane);
    const { x, y } = camera.centre();
    this.origin_x = pane.x + pane.width / 2 - x * this.scale;
    this.origin_y = middle(pane) + y * this.scale;
  }

  x(metres: number): number {
    return this.origin_x + metres * this.scale;
  }

  y(metres: number): number {
    return this.origin_y - metres * this.scale;
  }

  /** Whether a disc (px) may be visible. */
  holds(x: number, y: number, radius: number): boolean {
    const { pane } = this;
    return x + radius >= pane.x && x - radius <= pane.x + pane.width && y + radius >= pane.y && y - radius <= pane.y + pane.height;
  }
}
