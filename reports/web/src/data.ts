// The data that the C++ side writes into the page (the report, its series, replays and studies), and their validation.
// Data that does not fit is refused as a whole, with the path of every problem.
import { unpack_json } from "./packed";
import { replay_rule, type Replay } from "./replay/data";
import { finite, is_object, list, map, number, one_of, optional, or_null, record, text, yes_no, type Rule } from "./rules";

export interface Measured {
  value: number | null; // null if not finite
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
  ratio: number | null; // error / tolerance; null for a tolerance of 0 or an error that is not finite
  relative_error: number | null; // error / scale of the scene, without what chance explains; null for an unknown scale or an error that is not finite
  evidence: boolean; // false if the tolerance is too large for the check to be a test
  relation: "equal" | "at least" | "at most"; // of measured to expected
  passed: boolean;
  reported: boolean; // false if the engine does not report the quantity
  source: string;
  unit: string;
}

const statuses = ["held", "broken", "not reported", "not applicable"] as const;
export type CheckStatus = (typeof statuses)[number];

/** An invariant over a run, at the moment of its largest error. */
export interface InvariantCheck {
  name: string;
  unit: string;
  status: CheckStatus;
  value: number | null;
  tolerance: number | null;
  ratio: number | null; // value / tolerance; null for a tolerance of 0 or a value that is not finite
  evidence: boolean; // false if nothing in the run tested it
  time: number;
  where: string;
  phases?: number; // runs with shifted steps, of which it is the worst; absent for a single run
  detail?: string; // of a metamorphic relation: what was compared, and why that much may differ
}

const verdicts = ["right", "coarse", "wrong", "plausible", "no evidence", "beyond horizon", "not supported", "failed"] as const;
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

/** Between two runs, divided by a scale of the scene that is the same for all engines. */
export interface RelativeDifference {
  largest: number | null; // over time
  end: number | null;
}

/** The first things to know of two runs. */
export interface KeyDifferences {
  energy: RelativeDifference;
  momentum: RelativeDifference;
  angular_momentum: RelativeDifference;
  rest_a: number | null; // s, since when all bodies are at rest; null if one moves at the end
  rest_b: number | null;
  overlap_a: number | null; // m, the deepest; null if there are no two bodies
  overlap_b: number | null;
  diverged_at: number | null; // s; null: never
}

export interface Comparison {
  scenario: string;
  variant: string;
  a: string;
  b: string;
  key_differences: KeyDifferences | null; // null unless both runs reached their end
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

/** The description of a scenario; likewise for engines, metrics and invariants. */
export interface ScenarioNote {
  name: string;
  question: string;
  group?: string;
  parameters: { name: string; unit: string; about: string }[];
}

/** What the scenarios of a group ask about, and what is at stake if an engine fails there. */
export interface GroupNote {
  name: string;
  title: string;
  stake: string;
}

export interface EngineNote {
  name: string;
  about: string;
  source: string;
  word: string; // how a command line names it; "" if by its name
  language: string;
  execution: string; // how its code runs: "native", "WebAssembly", "JIT", "interpreted" or "not stated"
  states?: { method: string; text: string }[]; // how it steps, by its own word
  caveats?: string[]; // what it does differently from what a scene means
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
  groups?: GroupNote[];
  engines: EngineNote[];
  metrics: MetricNote[];
  invariants: InvariantNote[];
  runs: Run[];
  comparisons: Comparison[];
  timings: { steps: Timing[]; clock: Record<string, number | null> };
}

/** Columns of equal length, with one entry for each recorded moment. */
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
  fastest: (number | null)[]; // m/s, the speed of the fastest body
  pose_difference: (number | null)[];
  overlap: (number | null)[]; // m, the deepest of the moment
}

/** The series of a case, packed: only an opened case needs them. */
export interface Curves {
  scenario: string;
  variant: string;
  series: string;
}

/** A study as study-NAME.json has it; the view of each study knows its findings. */
export interface StudyResult {
  key: string;
  ending: "done" | "failed" | "crashed" | "timed out" | "out of memory";
  reason: string;
  values: Record<string, unknown>;
}

export interface Study {
  plumb: number;
  study: string;
  about: string;
  configuration: Record<string, unknown>;
  command?: string; // that runs the full study; only for short forms inside a report
  folder?: string; // of its files; only on a page of its own
  environment: Record<string, string>;
  results: StudyResult[];
  findings: Record<string, unknown>;
  timings: { results: Record<string, Record<string, unknown>> } & Record<string, unknown>;
}

const anything: Rule = () => {};

const study_rule = record({
  study: text,
  about: text,
  configuration: map(anything),
  folder: optional(text),
  environment: map(text),
  results: list(record({ key: text, ending: text, reason: text, values: map(anything) })),
  findings: map(anything),
  timings: record({ results: map(map(anything)) }),
});

export interface Page {
  report: Report;
  curves: Curves[];
  replays: Replay[];
  studies: Study[]; // short forms
}

/** The format of report.json this page reads. */
const format = 4;

const measured = record({ value: number, unit: text });
const of_case = { scenario: text, variant: text };
const of_run = { ...of_case, engine: text, method: text };

const difference = record({ largest: number, end: number });
const key_differences = record({
  energy: difference,
  momentum: difference,
  angular_momentum: difference,
  rest_a: number,
  rest_b: number,
  overlap_a: number,
  overlap_b: number,
  diverged_at: number,
});

const report_rule = record({
  title: text,
  command: list(text),
  environment: map(text),
  scenarios: list(record({ name: text, question: text, group: optional(text), parameters: list(record({ name: text, unit: text, about: text })) })),
  groups: optional(list(record({ name: text, title: text, stake: text }))),
  engines: list(record({ name: text, about: text, source: text, word: text, language: text, execution: text, exact: yes_no, caveats: optional(list(text)), states: optional(list(record({ method: text, text }))) })),
  metrics: list(record({ name: text, unit: text, definition: text })),
  invariants: list(record({ name: text, unit: text, definition: text })),
  runs: list(
    record({
      ...of_run,
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
          ratio: number,
          relative_error: number,
          evidence: yes_no,
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
          status: one_of(...statuses),
          value: number,
          tolerance: number,
          ratio: number,
          evidence: yes_no,
          time: finite,
          where: text,
          phases: optional(finite),
          detail: optional(text),
        }),
      ),
      verdict: one_of(...verdicts),
    }),
  ),
  comparisons: list(
    record({
      ...of_case,
      a: text,
      b: text,
      key_differences: or_null(key_differences),
      metrics: map(measured),
      verdict: one_of(...verdicts),
      reason: text,
    }),
  ),
  timings: record({
    steps: list(
      record({
        ...of_run,
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

const columns = ["energy", "momentum_x", "momentum_y", "angular_momentum", "fastest", "pose_difference", "overlap"] as const;

const series_shape = record({ ...of_run, t: list(finite), ...Object.fromEntries(columns.map((column) => [column, list(number)])) });

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
  curves: list(record({ scenario: text, variant: text, series: text })),
  replays: list(replay_rule),
  studies: list(study_rule),
});

/** The series of a case; throws if they are damaged. */
export function series_of({ series }: Curves): Series[] {
  const found = unpack_json(series);
  const problems: string[] = [];
  list(series_rule)(found, problems);
  if (problems.length) throw new Error(`series${problems[0] ?? ""}`);
  return found as Series[];
}

export type ReadResult = { page: Page } | { study: Study } | { problems: string[] };

/** The two kinds of page; "plumb" inside the named member is the version of its format. The member may be packed. */
const kinds = [
  { name: "report", rule: page_rule, format },
  { name: "study", rule: record({ study: study_rule }), format: 2 },
] as const;

/** Parses and validates the text of the data element; lists all problems with their paths. */
export function read(json: string | null | undefined): ReadResult {
  if (!json?.trim()) return { problems: ["the page holds no report"] };
  let value: unknown;
  try {
    value = JSON.parse(json);
  } catch (error) {
    return { problems: [`the report is not JSON: ${(error as Error).message}`] };
  }
  const kind = kinds.find(({ name }) => is_object(value) && name in value) ?? kinds[0];
  if (is_object(value) && typeof value[kind.name] === "string") {
    try {
      value[kind.name] = unpack_json(value[kind.name] as string);
    } catch (error) {
      return { problems: [`${kind.name}: ${(error as Error).message}`] };
    }
  }
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
