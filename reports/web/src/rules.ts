// Validation of JSON values: a rule for each kind of value, and a list of all problems with their paths.

/** Appends problems of a value, each with its path inside the value. */
export type Rule = (value: unknown, problems: string[]) => void;

const kind = (value: unknown): string =>
  value === null ? "null" : value === undefined ? "nothing" : Array.isArray(value) ? "a list" : `a ${typeof value}`;

const expect =
  (fits: (value: unknown) => boolean, what: string): Rule =>
  (value, problems) => {
    if (!fits(value)) problems.push(`: expected ${what}, found ${kind(value)}`);
  };

export const text = expect((value) => typeof value === "string", "a text");
export const yes_no = expect((value) => typeof value === "boolean", "true or false");
export const finite = expect((value) => typeof value === "number", "a number");
export const number = expect((value) => typeof value === "number" || value === null, "a number or null");
export const one_of = (...words: readonly string[]): Rule =>
  expect((value) => words.includes(value as string), `one of ${words.join(", ")}`);

/** Applies a rule to a part and prefixes its problems with the part's path. Paths are built only for problems: there are many parts. */
function part(rule: Rule, value: unknown, problems: string[], path: (key: string | number) => string, key: string | number): void {
  const before = problems.length;
  rule(value, problems);
  for (let i = before; i < problems.length; ++i) problems[i] = path(key) + (problems[i] ?? "");
}

const as_index = (index: string | number): string => `[${index}]`;
const as_name = (name: string | number): string => `["${name}"]`;
const as_field = (name: string | number): string => `.${name}`;

export const list =
  (rule: Rule): Rule =>
  (value, problems) => {
    if (!Array.isArray(value)) problems.push(`: expected a list, found ${kind(value)}`);
    else for (let index = 0; index < value.length; ++index) part(rule, value[index], problems, as_index, index);
  };

export const is_object = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

export const or_null =
  (rule: Rule): Rule =>
  (value, problems) => {
    if (value !== null) rule(value, problems);
  };

export const optional =
  (rule: Rule): Rule =>
  (value, problems) => {
    if (value !== undefined) rule(value, problems);
  };

export const map =
  (rule: Rule): Rule =>
  (value, problems) => {
    if (!is_object(value)) problems.push(`: expected names with values, found ${kind(value)}`);
    else for (const name in value) part(rule, value[name], problems, as_name, name);
  };

export const record = (rules: Record<string, Rule>): Rule => {
  const fields = Object.entries(rules);
  return (value, problems) => {
    if (!is_object(value)) problems.push(`: expected an object, found ${kind(value)}`);
    else for (const [name, rule] of fields) part(rule, value[name], problems, as_field, name);
  };
};
