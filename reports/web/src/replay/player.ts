// Lets time run, when asked to: nothing plays by itself.
import type { Cursor } from "./cursor";

export const speeds = [0.05, 0.1, 0.25, 0.5, 1, 2, 4];
/** s; a tab that comes back does not leap ahead. */
const longest_frame = 0.1;

export class Player {
  speed = 1;
  loop = false;
  private frame = 0;
  private last = 0; // ms

  constructor(
    private readonly cursor: Cursor,
    private readonly changed: () => void,
  ) {}

  get playing(): boolean {
    return this.frame !== 0;
  }

  toggle(): void {
    if (this.playing) {
      this.pause();
      return;
    }
    if (this.cursor.time >= this.cursor.end) this.cursor.set(0);
    this.last = performance.now();
    this.frame = requestAnimationFrame(this.advance);
    this.changed();
  }

  pause(): void {
    if (!this.playing) return;
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.changed();
  }

  faster(by: 1 | -1): void {
    this.speed = speeds[Math.min(speeds.length - 1, Math.max(0, speeds.indexOf(this.speed) + by))] ?? 1;
    this.changed();
  }

  private readonly advance = (now: number): void => {
    this.frame = requestAnimationFrame(this.advance);
    const passed = Math.min(longest_frame, Math.max(0, (now - this.last) / 1000));
    this.last = now;
    const next = this.cursor.time + passed * this.speed;
    if (next < this.cursor.end) this.cursor.set(next);
    else if (this.loop) this.cursor.set(0);
    else {
      this.cursor.set(this.cursor.end);
      this.pause();
    }
  };
}
