// From metres, y up, to pixels, y down.

export interface Bounds {
  left: number; // m; so the others
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
}

const margin = 0.06; // of the pane, left free around what is shown
const most_zoom = 1000;

export class Camera {
  private zoom = 1;
  private shift_x = 0; // m
  private shift_y = 0;

  constructor(private readonly bounds: Bounds) {}

  /** px per m */
  scale(pane: Pane): number {
    const { left, bottom, right, top } = this.bounds;
    const room = 1 - 2 * margin;
    return this.zoom * Math.min((room * pane.width) / (right - left), (room * pane.height) / (top - bottom));
  }

  /** m, in the pane's middle */
  centre(): { x: number; y: number } {
    const { left, bottom, right, top } = this.bounds;
    return { x: (left + right) / 2 + this.shift_x, y: (bottom + top) / 2 + this.shift_y };
  }

  fit(): void {
    this.zoom = 1;
    this.shift_x = 0;
    this.shift_y = 0;
  }

  /** By px on a pane. */
  pan(x: number, y: number, pane: Pane): void {
    const scale = this.scale(pane);
    this.shift_x -= x / scale;
    this.shift_y += y / scale;
  }

  /** What lies at a place of the pane stays there. */
  zoom_by(factor: number, pane: Pane, x = pane.x + pane.width / 2, y = pane.y + pane.height / 2): void {
    const right = x - pane.x - pane.width / 2;
    const down = y - pane.y - pane.height / 2;
    const before = this.scale(pane);
    this.zoom = Math.min(most_zoom, Math.max(1 / 8, this.zoom * factor));
    const after = this.scale(pane);
    this.shift_x += right / before - right / after;
    this.shift_y -= down / before - down / after;
  }
}
