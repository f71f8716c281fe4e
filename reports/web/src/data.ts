// What the C++ side hands to the page, and the check that it is that. The page trusts nothing else: a report that does
// not fit is refused whole, with the places named.

import { finite, is_object, list, map, number, one_of, record, text, yes_no, type Rule } from "./rules";
import { replay_rule, type Replay } from "./replay/data";
import { study_rule, type Study } from "./study";

export interface Measured {
  value: number | null; // null: not finite
  unit: string;
}

export interface TruthCheck {
  body: string;
  quantity: string;
  time: number;
  expected: number | null;
  measured: number | null;
  error: number | null;
  tolerance: number | null;
  relation: "equal" | "at least" | "at most"; // of measured to expected
  passed: boolean;
  reported: boolean; // false: the engine does not show it
  source: string;
  unit: string;
}

export const standings = ["held", "broken", "not reported"] as const;
export type Standing = (typeof standings)[number];

/** How an invariant fared over a run, where it was missed most. */
export interface InvariantCheck {
  name: string;
  unit: string;
  status: Standing;
  value: number | null;
  tolerance: number | null;
  ratio: number | null; // null: nothing is allowed
  time: number;
  where: string;
}

export const verdicts = ["right", "plausible", "wrong", "beyond horizon", "not supported", "failed"] as const;
export type Verdict = (typeof verdicts)[number];

export interface Run {
  scenario: string;
  variant: string;
  parameters: Record<string, number>;
  engine: string;
  method: string;
  exact: boolean;
  dt: number;
  status: "ok" | "failed" | "not supported";
  reason: string;
  metrics: Record<string, Measured>;
  truth: TruthCheck[];
  invariants: InvariantCheck[];
  verdict: Verdict;
}

export interface Comparison {
  scenario: string;
  variant: string;
  a: string;
  b: string;
  metrics: Record<string, Measured>;
  verdict: Verdict;
  reason: string;
}

export interface Timing {
  scenario: string;
  variant: string;
  engine: string;
  method: string;
  step_us: number | null;
  step_us_low: number | null;
  step_us_high: number | null;
  real_time_factor: number | null;
  repetitions: number;
}

/** What scenarios, engines and metrics say of themselves. */
export interface ScenarioNote {
  name: string;
  question: string;
  parameters: { name: string; unit: string; about: string }[];
}

export interface EngineNote {
  name: string;
  about: string;
  source: string;
  exact: boolean;
}

export interface MetricNote {
  name: string;
  unit: string;
  definition: string;
}

export interface InvariantNote {
  name: string;
  unit: string;
  definition: string;
}

export interface Report {
  plumb: number;
  title: string;
  command: string[];
  environment: Record<string, string>;
  scenarios: ScenarioNote[];
  engines: EngineNote[];
  metrics: MetricNote[];
  invariants: InvariantNote[];
  runs: Run[];
  comparisons: Comparison[];
  timings: { steps: Timing[]; clock: Record<string, number | null> };
}

/** Columns of equal length: one entry a recorded moment. */
export interface Series {
  scenario: string;
  variant: string;
  engine: string;
  method: string;
  t: number[];
  energy: (number | null)[];
  momentum_x: (number | null)[];
  momentum_y: (number | null)[];
  angular_momentum: (number | null)[];
  pose_difference: (number | null)[];
  overlap: (number | null)[]; // m, the deepest
}

export interface Page {
  report: Report;
  series: Series[];
  replays: Replay[];
  studies: Study[]; // short forms
}

/** The format of report.json this page reads. */
export const format = 2;

const measured = record({ value: number, unit: text });
const place = { scenario: text, variant: text };
const engine = { ...place, engine: text, method: text };

const report_rule = record({
  title: text,
  command: list(text),
  environment: map(text),
  scenarios: list(record({ name: text, question: text, parameters: list(record({ name: text, unit: text, about: text })) })),
  engines: list(record({ name: text, about: text, source: text, exact: yes_no })),
  metrics: list(record({ name: text, unit: text, definition: text })),
  invariants: list(record({ name: text, unit: text, definition: text })),
  runs: list(
    record({
      ...engine,
      parameters: map(finite),
      exact: yes_no,
      dt: finite,
      status: one_of("ok", "failed", "not supported"),
      reason: text,
      metrics: map(measured),
      truth: list(
        record({
          body: text,
          quantity: text,
          time: finite,
          expected: number,
          measured: number,
          error: number,
          tolerance: number,
          relation: one_of("equal", "at least", "at most"),
          passed: yes_no,
          reported: yes_no,
          source: text,
          unit: text,
        }),
      ),
      invariants: list(
        record({
          name: text,
          unit: text,
          status: one_of(...standings),
          value: number,
          tolerance: number,
          ratio: number,
          time: finite,
          where: text,
        }),
      ),
      verdict: one_of(...verdicts),
    }),
  ),
  comparisons: list(
    record({ ...place, a: text, b: text, metrics: map(measured), verdict: one_of(...verdicts), reason: text }),
  ),
  timings: record({
    steps: list(
      record({
        ...engine,
        step_us: number,
        step_us_low: number,
        step_us_high: number,
        real_time_factor: number,
        repetitions: finite,
      }),
    ),
    clock: map(number),
  }),
});

const columns = ["energy", "momentum_x", "momentum_y", "angular_momentum", "pose_difference", "overlap"] as const;

const series_shape = record({ ...engine, t: list(finite), ...Object.fromEntries(columns.map((column) => [column, list(number)])) });

const series_rule: Rule = (value, problems) => {
  const before = problems.length;
  series_shape(value, problems);
  if (problems.length > before) return;
  const series = value as Series;
  for (const column of columns) {
    if (series[column].length !== series.t.length) {
      problems.push(`.${column}: ${series[column].length} values for ${series.t.length} times`);
    }
  }
};

const page_rule = record({
  report: report_rule,
  series: list(series_rule),
  replays: list(replay_rule),
  studies: list(study_rule),
});

export type Outcome = { page: Page } | { study: Study } | { problems: string[] };

/** Where in the data its kind keeps the number of its format. */
const kinds = [
  { name: "report", rule: page_rule, format },
  { name: "study", rule: record({ study: study_rule }), format: 2 },
] as const;

/** Reads the text of the data element; says all that is wrong with it, place by place. */
export function read(json: string | null | undefined): Outcome {
  if (!json?.trim()) return { problems: ["the page holds no report"] };
  let value: unknown;
  try {
    value = JSON.parse(json);
  } catch (error) {
    return { problems: [`the report is not JSON: ${(error as Error).message}`] };
  }
  const kind = kinds.find(({ name }) => is_object(value) && name in value) ?? kinds[0];
  const inner = is_object(value) ? value[kind.name] : undefined;
  const version = is_object(inner) ? inner["plumb"] : undefined;
  if (version !== undefined && version !== kind.format) {
    return {
      problems: [`${kind.name}.plumb: the ${kind.name} is of format ${String(version)}, this page reads format ${kind.format}`],
    };
  }
  const problems: string[] = [];
  if (version === undefined) problems.push(`${kind.name}.plumb: expected ${kind.format}, the number of the format, found nothing`);
  kind.rule(value, problems);
  if (problems.length) return { problems: problems.map((problem) => problem.replace(/^\./, "")) };
  return kind.name === "study" ? { study: (value as { study: Study }).study } : { page: value as Page };
}
