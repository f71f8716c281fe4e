// The data of a replay as reports/writers/replay.h describes it, its validation, and the decoder of packed columns
// (reports/writers/packed.h), which validates them as it reads.
import { finite, list, number, one_of, or_null, record, text } from "../rules";

export interface Peak {
  time: number; // s
  value: number; // m
}

/** `poses` and `touches` are packed. */
export interface ReplayRun {
  engine: string;
  method: string;
  moments: number; // kept
  every: number; // steps from one kept moment to the next
  between: number; // m, largest error of linear interpolation between kept moments
  length: number; // m, resolution of positions; likewise the next three
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

/** The hull of its points grown by a radius, or a half-space. */
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

/** The anchors of a joint or spring; `a` is null for an anchor in the world. */
export interface Joint {
  a: number | null;
  b: number;
  at_a: Pair;
  at_b: Pair;
}

export interface Scene {
  outlines: Outline[];
  bodies: Body[];
  joints: Joint[];
}

const half_space = record({ normal: list(finite), offset: finite });
const hull = record({ points: list(list(finite)), radius: finite });

export const scene_rule = record({
  outlines: list((value, problems) => ((value as Outline | null)?.normal ? half_space : hull)(value, problems)),
  bodies: list(record({ name: text, type: one_of("fixed", "kinematic", "dynamic"), outlines: list(finite) })),
  joints: list(record({ a: number, b: finite, at_a: list(finite), at_b: list(finite) })),
});

/** Reads integers of variable length one by one, and columns of them. */
export class Numbers {
  private position = 0;

  constructor(private readonly bytes: Uint8Array) {}

  get ended(): boolean {
    return this.position === this.bytes.length;
  }

  next(): number {
    let value = 0;
    let weight = 1;
    for (;;) {
      const byte = this.bytes[this.position++];
      if (byte === undefined) throw new Error("a packed column ends too early");
      value += (byte & 127) * weight;
      if (byte < 128) break;
      weight *= 128;
    }
    return value % 2 ? -(value + 1) / 2 : value / 2;
  }

  /** A column of second differences, into every stride-th element of `out` from `start`. */
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

  /** A column of first differences. */
  steady(count: number, step: number, out: Float64Array, start = 0, stride = 1): void {
    let last = 0;
    for (let i = 0; i < count; ++i) {
      last += this.next();
      out[start + i * stride] = last * step;
    }
  }
}
