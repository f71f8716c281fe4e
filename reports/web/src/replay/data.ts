// What the C++ side hands over for a replay; what is packed is checked when it is unpacked.
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
