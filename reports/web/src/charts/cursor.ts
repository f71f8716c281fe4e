// The time that the replay and the charts of a case share, and its line on a chart, which a click or drag moves.
import type { Plot } from "@observablehq/plot";
import { svg } from "../dom";

export class Cursor {
  private now = 0;
  private readonly listeners = new Set<() => void>();

  constructor(readonly end: number) {} // s

  get time(): number {
    return this.now;
  }

  set(time: number): void {
    const next = Math.min(this.end, Math.max(0, time));
    if (next === this.now) return;
    this.now = next;
    for (const listener of this.listeners) listener();
  }

  /** Calls back on every change; returns a function that stops it. */
  on(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}

/** Draws the time on a chart with time as its x axis. */
export function playhead(chart: (SVGSVGElement | HTMLElement) & Plot, cursor: Cursor): void {
  const time = chart.scale("x");
  const value = chart.scale("y");
  if (!time?.invert || !value?.range) return;
  const [bottom, top] = value.range as number[];
  const line = svg("line", { class: "playhead", y1: bottom ?? 0, y2: top ?? 0 });
  chart.append(line);
  const follow = (): void => {
    if (line.isConnected || !drawn) {
      const x = String(time.apply(cursor.time));
      line.setAttribute("x1", x);
      line.setAttribute("x2", x);
      drawn ||= line.isConnected;
    } else {
      stop(); // the chart was redrawn at another width
    }
  };
  let drawn = false;
  const stop = cursor.on(follow);
  follow();

  const set = (event: PointerEvent): void => {
    const left = chart.getBoundingClientRect().left;
    cursor.set(Number(time.invert?.(event.clientX - left)));
    // Otherwise Plot pins its tip here.
    event.stopImmediatePropagation();
  };
  chart.addEventListener("pointerdown", (event) => set(event as PointerEvent), { capture: true });
  chart.addEventListener("pointermove", (event) => (event as PointerEvent).buttons === 1 && set(event as PointerEvent), { capture: true });
}
