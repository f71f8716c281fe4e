// A study as the C++ side hands it over (study-NAME.json). What its findings hold, each study's own view knows.
import { list, map, record, text, type Rule } from "./rules";

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
  command?: string; // that makes it: of a short form inside a report
  environment: Record<string, string>;
  results: StudyResult[];
  findings: Record<string, unknown>;
  timings: { results: Record<string, Record<string, unknown>> } & Record<string, unknown>;
}

const anything: Rule = () => {};

export const study_rule = record({
  study: text,
  about: text,
  configuration: map(anything),
  environment: map(text),
  results: list(record({ key: text, ending: text, reason: text, values: map(anything) })),
  findings: map(anything),
  timings: record({ results: map(map(anything)) }),
});

/** What a study's page is made of: a sentence to read first, and its sections with their ids and names. */
export interface StudyView {
  sentence: string;
  sections: { id: string; name: string; content: () => HTMLElement }[];
}
