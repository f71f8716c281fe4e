// The stability study as its page thinks of it.
import type { Study } from "../data";

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
  failing: string[]; // outcomes; none: all failures
  source: string; // of its theory, "" where there is none
  agreement: number;
  natural: boolean; // theory is nature's: to hold beyond it is no merit
}

/** Where a method ceased to hold; open where nothing bounds it. */
export interface Bracket {
  low: number | null;
  high: number | null;
  outcome: string;
  time: number | null;
  body: string;
  theory: number | "never" | null;
  agrees: boolean | null; // null where there is nothing to compare
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
  y: Axis | null; // null where the method has nothing to vary
  rows: MapRow[];
  why: string; // not supported
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
  y: Axis | null; // null: what makes each method work harder
  typical: number;
  metrics: string[];
  boundaries: Boundary[];
  panels: Panel[];
  agreements: Agreement[];
}

export interface StabilityModel {
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

type Told = Omit<StabilityMap, "panels">;

const label_of = ({ engine, method }: Values): string => (method ? `${engine}:${method}` : engine);

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
  const findings = study.findings as unknown as { outcomes: Outcome[]; maps: Told[] };
  const outcomes = new Map(findings.outcomes.map((outcome) => [outcome.letter, outcome]));
  const maps = findings.maps.map((told): StabilityMap => {
    const panels = new Map<string, Panel>();
    for (const { key, ending, values: raw } of study.results) {
      const values = raw as unknown as Values;
      if (ending !== "done" || values.map !== told.name) continue;
      const engine = label_of(values);
      const work: Axis | null = values.option
        ? { name: values.option, unit: "", from: 1, to: 1, logarithmic: true, whole: true }
        : null;
      const panel = panels.get(engine) ?? { engine, y: told.y ?? work, rows: [], why: values.why };
      panels.set(engine, panel);
      panel.rows.push({
        key,
        y: values.y,
        typical: values.typical,
        cells: [...values.outcomes].flatMap((letter, index) => {
          const outcome = outcomes.get(letter);
          const x = told.x.values[index];
          return outcome && x !== undefined ? { x, outcome, since: values.since[index] ?? null, body: values.bodies[index] ?? "" } : [];
        }),
        brackets: told.boundaries.map(({ name }) => bracket_of(raw, name)),
      });
    }
    return { ...told, panels: [...panels.values()] };
  });
  return { outcomes: findings.outcomes, maps };
}

/** Whether every cell is one that the method cannot run. */
export const is_absent = (panel: Panel): boolean => panel.rows.every(({ cells }) => cells.every(({ outcome }) => outcome.letter === "-"));

/** How far along the axis a bracket's last holding value is; less than 0 where none held. */
function extent({ from, to, logarithmic }: Axis, { low }: Bracket): number {
  if (low === null) return -1;
  return logarithmic ? Math.log(low / from) / Math.log(to / from) : (low - from) / (to - from);
}

/** Where methods are compared: the row at their own settings, or at the map's typical y. */
export const typical_row = (panel: Panel): MapRow | undefined => panel.rows.find(({ typical }) => typical);

/** Who of the engines stands most in a map: what nature does, where that is known, else the farthest. */
export function best_of(map: StabilityMap, engines: string[]): Set<string> {
  const found = map.panels.flatMap((panel) => {
    const bracket = typical_row(panel)?.brackets[0];
    return bracket && engines.includes(panel.engine) ? { engine: panel.engine, bracket, reach: extent(map.x, bracket) } : [];
  });
  const farthest = Math.max(0, ...found.map(({ reach }) => reach));
  const good = map.boundaries[0]?.natural ? found.filter(({ bracket }) => bracket.agrees) : found.filter(({ reach }) => reach >= farthest);
  return new Set(good.map(({ engine }) => engine));
}
