// What the C++ side hands over for a replay; what is packed is checked when it is unpacked.
// The other end of reports/writers/packed.h.
import { finite, list, number, one_of, or_null, record, text } from "../rules";

export interface Peak {
  time: number; // s
  value: number; // m
}

/** Columns are packed; see reports/writers/replay.h for what they hold. */
export interface ReplayRun {
  engine: string;
  method: string;
  moments: number; // kept
  every: number; // of the steps that were run
  between: number; // m, by which straight lines between kept moments are off at most
  length: number; // m, step of the rounding; so the next three
  angle: number; // rad
  impulse: number; // N s
  energy: number; // J
  contacts: "kept" | "none" | "too many";
  apart: Peak | null;
  overlap: (Peak & { a: number; b: number }) | null;
  poses: string;
  touches: string;
}

export interface Replay {
  scenario: string;
  variant: string;
  scene: string;
  runs: ReplayRun[];
}

const peak = { time: finite, value: finite };

export const replay_rule = record({
  scenario: text,
  variant: text,
  scene: text,
  runs: list(
    record({
      engine: text,
      method: text,
      moments: finite,
      every: finite,
      between: finite,
      length: finite,
      angle: finite,
      impulse: finite,
      energy: finite,
      contacts: one_of("kept", "none", "too many"),
      apart: or_null(record(peak)),
      overlap: or_null(record({ ...peak, a: finite, b: finite })),
      poses: text,
      touches: text,
    }),
  ),
});

export type Pair = [number, number];

/** The hull of its points grown by a radius, or all that lies below a line. */
export interface Outline {
  points?: Pair[];
  radius?: number; // m
  normal?: Pair;
  offset?: number; // m
}

export interface Body {
  name: string;
  type: "fixed" | "kinematic" | "dynamic";
  outlines: number[];
}

/** Two points that a joint or spring joins; `a` null: a point of the world. */
export interface Tie {
  a: number | null;
  b: number;
  at_a: Pair;
  at_b: Pair;
}

export interface Scene {
  outlines: Outline[];
  bodies: Body[];
  ties: Tie[];
}

const half_space = record({ normal: list(finite), offset: finite });
const hull = record({ points: list(list(finite)), radius: finite });

export const scene_rule = record({
  outlines: list((value, problems) => ((value as Outline | null)?.normal ? half_space : hull)(value, problems)),
  bodies: list(record({ name: text, type: one_of("fixed", "kinematic", "dynamic"), outlines: list(finite) })),
  ties: list(record({ a: number, b: finite, at_a: list(finite), at_b: list(finite) })),
});

/** Base64 of deflated bytes -> bytes. Throws where it is damaged. */
export async function unpack(text: string): Promise<Uint8Array> {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Whole numbers in turn, and columns of them. */
export class Numbers {
  private place = 0;

  constructor(private readonly bytes: Uint8Array) {}

  get ended(): boolean {
    return this.place === this.bytes.length;
  }

  next(): number {
    let value = 0;
    let weight = 1;
    for (;;) {
      const byte = this.bytes[this.place++];
      if (byte === undefined) throw new Error("a packed column ends too early");
      value += (byte & 127) * weight;
      if (byte < 128) break;
      weight *= 128;
    }
    return value % 2 ? -(value + 1) / 2 : value / 2;
  }

  /** Into every stride-th place of `out` from `start` on. */
  smooth(count: number, step: number, out: Float64Array, start = 0, stride = 1): void {
    let before = 0;
    let last = 0;
    for (let i = 0; i < count; ++i) {
      const now = this.next() + 2 * last - before;
      out[start + i * stride] = now * step;
      before = last;
      last = now;
    }
  }

  steady(count: number, step: number, out: Float64Array, start = 0, stride = 1): void {
    let last = 0;
    for (let i = 0; i < count; ++i) {
      last += this.next();
      out[start + i * stride] = last * step;
    }
  }
}
