// The findings of the stability study, as its view uses them.
import type { Study } from "../data";
import { label_of } from "../model";

export interface Outcome {
  letter: string;
  name: string;
  about: string;
}

export interface Axis {
  name: string;
  unit: string;
  from: number;
  to: number;
  logarithmic: boolean;
  whole: boolean;
}

export interface Boundary {
  name: string;
  failing: string[]; // outcomes that count as failing; empty: all failures
  source: string; // of the theory; "" if there is none
  agreement: number;
  natural: boolean; // a law of physics: holding beyond it is wrong
}

/** The bracket of a method's boundary: the last value that holds and the first that fails; null where the map ends. */
export interface Bracket {
  low: number | null;
  high: number | null;
  outcome: string;
  time: number | null;
  body: string;
  theory: number | "never" | null;
  agrees: boolean | null; // null if there is nothing to compare
}

export interface Cell {
  x: number;
  outcome: Outcome;
  since: number | null; // s
  body: string;
}

export interface MapRow {
  key: string;
  y: number;
  typical: boolean;
  cells: Cell[];
  brackets: Bracket[]; // by boundary
}

/** One method in one map. */
export interface Panel {
  engine: string;
  y: Axis | null; // null if the method has no option to vary
  rows: MapRow[];
  why: string; // it is not supported
}

export interface Agreement {
  engine: string;
  boundary: string;
  rows: number;
  agree: number;
  worst: number | null;
}

export interface StabilityMap {
  name: string;
  question: string;
  x: Axis & { values: number[] };
  y: Axis | null; // null: the option that makes each method work harder
  typical: number;
  metrics: string[];
  boundaries: Boundary[];
  panels: Panel[];
  agreements: Agreement[];
  best: string[]; // the methods that agree with the law of physics, or else hold the farthest
  failed: Map<string, string>; // why a method has no limit, by method
}

export interface StabilityModel {
  sentence: string; // the result
  outcomes: Outcome[];
  maps: StabilityMap[];
}

interface Values {
  map: string;
  engine: string;
  method: string;
  option: string;
  y: number;
  typical: boolean;
  outcomes: string;
  why: string;
  since: (number | null)[];
  bodies: string[];
}

interface MapFindings extends Omit<StabilityMap, "panels" | "failed"> {
  limits: { engine: string; low?: number | null; failed?: string }[]; // without "low" if the row of the limit failed
}

function bracket_of(values: Record<string, unknown>, boundary: string): Bracket {
  const of = (what: string): unknown => values[`${boundary}_${what}`];
  const number = (what: string): number | null => (typeof of(what) === "number" ? (of(what) as number) : null);
  const theory = of("theory");
  return {
    low: number("low"),
    high: number("high"),
    outcome: String(of("outcome") ?? ""),
    time: number("time"),
    body: String(of("body") ?? ""),
    theory: theory === "never" ? "never" : number("theory"),
    agrees: typeof of("agrees") === "boolean" ? (of("agrees") as boolean) : null,
  };
}

export function stability_model(study: Study): StabilityModel {
  const findings = study.findings as unknown as { sentence: string; outcomes: Outcome[]; maps: MapFindings[] };
  const outcomes = new Map(findings.outcomes.map((outcome) => [outcome.letter, outcome]));
  const maps = findings.maps.map((map): StabilityMap => {
    const panels = new Map<string, Panel>();
    for (const { key, ending, values: raw } of study.results) {
      const values = raw as unknown as Values;
      if (ending !== "done" || values.map !== map.name) continue;
      const engine = label_of(values);
      const work: Axis | null = values.option
        ? { name: values.option, unit: "", from: 1, to: 1, logarithmic: true, whole: true }
        : null;
      const panel = panels.get(engine) ?? { engine, y: map.y ?? work, rows: [], why: values.why };
      panels.set(engine, panel);
      panel.rows.push({
        key,
        y: values.y,
        typical: values.typical,
        cells: [...values.outcomes].flatMap((letter, index) => {
          const outcome = outcomes.get(letter);
          const x = map.x.values[index];
          return outcome && x !== undefined ? { x, outcome, since: values.since[index] ?? null, body: values.bodies[index] ?? "" } : [];
        }),
        brackets: map.boundaries.map(({ name }) => bracket_of(raw, name)),
      });
    }
    const failed = new Map(map.limits.flatMap(({ engine, low, failed }): [string, string][] => (low === undefined ? [[engine, failed ?? ""]] : [])));
    return { ...map, panels: [...panels.values()], failed };
  });
  return { sentence: findings.sentence, outcomes: findings.outcomes, maps };
}

/** Whether the method supports no cell. */
export const is_absent = (panel: Panel): boolean => panel.rows.every(({ cells }) => cells.every(({ outcome }) => outcome.letter === "-"));

/** The row in which methods are compared: their default settings, or the map's typical y. */
export const typical_row = (panel: Panel): MapRow | undefined => panel.rows.find(({ typical }) => typical);
