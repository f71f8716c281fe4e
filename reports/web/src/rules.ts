// What a value must be, and all that is wrong with it, place by place.

export type Rule = (value: unknown, path: string, problems: string[]) => void;

const kind = (value: unknown): string =>
  value === null ? "null" : value === undefined ? "nothing" : Array.isArray(value) ? "a list" : `a ${typeof value}`;

const expect =
  (fits: (value: unknown) => boolean, what: string): Rule =>
  (value, path, problems) => {
    if (!fits(value)) problems.push(`${path}: expected ${what}, found ${kind(value)}`);
  };

export const text = expect((value) => typeof value === "string", "a text");
export const yes_no = expect((value) => typeof value === "boolean", "true or false");
export const finite = expect((value) => typeof value === "number", "a number");
export const number = expect((value) => typeof value === "number" || value === null, "a number or null");
export const one_of = (...words: readonly string[]): Rule =>
  expect((value) => words.includes(value as string), `one of ${words.join(", ")}`);

export const list =
  (rule: Rule): Rule =>
  (value, path, problems) => {
    if (!Array.isArray(value)) problems.push(`${path}: expected a list, found ${kind(value)}`);
    else value.forEach((item, index) => rule(item, `${path}[${index}]`, problems));
  };

export const is_object = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

export const or_null =
  (rule: Rule): Rule =>
  (value, path, problems) => {
    if (value !== null) rule(value, path, problems);
  };

export const map =
  (rule: Rule): Rule =>
  (value, path, problems) => {
    if (!is_object(value)) problems.push(`${path}: expected names with values, found ${kind(value)}`);
    else for (const [name, item] of Object.entries(value)) rule(item, `${path}["${name}"]`, problems);
  };

export const record =
  (rules: Record<string, Rule>): Rule =>
  (value, path, problems) => {
    if (!is_object(value)) problems.push(`${path}: expected an object, found ${kind(value)}`);
    else for (const [name, rule] of Object.entries(rules)) rule(value[name], `${path}.${name}`, problems);
  };
