// Playing a replay, which never starts by itself, and jumping to its most interesting moments.
import type { Cursor } from "../charts/cursor";
import { number } from "../format";
import { label_of, type Replayed } from "../model";
import type { Film } from "./film";

export const speeds = [0.05, 0.1, 0.25, 0.5, 1, 2, 4];
/** s; keeps a tab that was in the background from skipping ahead. */
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

export interface Jump {
  name: string;
  key: string;
  about: string;
  /** Searches the films shown; undefined if there is no such moment. */
  find: (films: Film[]) => Found | undefined;
}

export interface Found {
  film: Film;
  time: number; // s
  text: string;
  body?: number;
}

function largest(films: Film[], peak: (film: Film) => { time: number; value: number } | null): Found | undefined {
  let found: (Found & { value: number }) | undefined;
  for (const film of films) {
    const at = peak(film);
    if (at && (!found || at.value > found.value)) {
      found = { film, time: at.time, value: at.value, text: `${number(at.value, "m", 2)}, ${film.engine.label}` };
    }
  }
  return found;
}

export function jumps_of({ comparisons, entries }: Replayed): Jump[] {
  const reference = (entries.find(({ engine, run }) => engine.exact && run.status === "ok") ?? entries.find(({ run }) => run.status === "ok"))?.run;
  const name = reference ? label_of(reference) : "";
  const diverged_at = (film: Film): number | undefined => {
    const label = label_of(film.run);
    const pair = comparisons.find(({ a, b }) => label !== name && ((a === label && b === name) || (a === name && b === label)));
    return pair?.key_differences?.diverged_at ?? undefined;
  };
  const from = reference?.exact ? "the truth" : name;
  return [
    {
      name: "First divergence",
      key: "1",
      about: `when the first of the shown runs is 1 cm (RMS over the bodies) from ${from}`,
      find: (films) => {
        let found: Found | undefined;
        for (const film of films) {
          const time = diverged_at(film);
          if (time !== undefined && (!found || time < found.time)) found = { film, time, text: film.engine.label };
        }
        return found;
      },
    },
    {
      name: "Largest error",
      key: "2",
      about: `when a shown run is furthest from ${from} (RMS over the bodies)`,
      find: (films) => largest(films, ({ run }) => run.apart),
    },
    {
      name: "Worst overlap",
      key: "3",
      about: "when two bodies of a shown run overlap the most, by the scene\u2019s geometry",
      find: (films) => {
        const found = largest(films, ({ run }) => run.overlap);
        const body = found?.film.run.overlap?.b;
        return found && body !== undefined ? { ...found, body } : found;
      },
    },
  ];
}
