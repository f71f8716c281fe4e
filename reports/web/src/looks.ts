// The look of an engine: colour (a palette that is safe for colour-blind readers), shape and dash. It depends on the
// engine's name alone, so an engine looks the same in every report, whatever else is in it. Methods and builds of an
// engine have its colour, in two tones, and shapes and dashes of their own.

export interface Look {
  color: string;
  symbol: string;
  dash: string;
}

/** Their numbers have no common divisor, so that counting through both at once meets every combination. */
const symbols = ["circle", "square", "triangle", "diamond", "wye", "star", "cross"];
const dashes = ["", "7 3", "2 3", "9 3 2 3", "12 4", "4 2"];
const marks = symbols.length * dashes.length;

/** By colour: the names of an engine, then methods of it that are shown often. Each has the mark of its index. */
const known = [
  [
    "impulse",
    "impulse:solver=article",
    "impulse:solver=sequential-impulse",
    "impulse:solver=split-impulse",
    "impulse:solver=soft-step",
    "impulse:solver=xpbd",
    "impulse:solver=block",
    "impulse:solver=exact",
    "impulse:model=auto",
    "impulse:precision=float",
    "impulse:continuous=off",
  ],
  ["box2d", "box2d:restitution=0", "box2d:continuous=off"],
  ["chipmunk", "chipmunk:slop=0.1"],
  ["box2d-v3", "box2d3-wasm", "box2d3"],
  ["rapier"],
  ["planck"],
  ["matter"],
];
const most_known = Math.max(...known.map((names) => names.length));
const colors = 10; // the last ones are for other engines

/** FNV-1a */
function hash(text: string): number {
  let value = 0x811c9dc5;
  for (const letter of text) value = Math.imul(value ^ (letter.codePointAt(0) ?? 0), 0x01000193) >>> 0;
  return value;
}

/** Without version and settings: "box2d@2.4:velocity=4" is box2d. */
const engine_of = (label: string): string => label.split(/[@:]/)[0] ?? label;

/** The look of an engine or method, by the name that --engine takes. */
export function look_of(label: string): Look {
  const engine = engine_of(label);
  const family = known.findIndex((names) => names.some((name) => engine_of(name) === engine));
  const names = known[family] ?? [];
  const other = family < 0 ? hash(label) % marks : most_known + (hash(label) % (marks - most_known));
  const mark = names.includes(label) ? names.indexOf(label) : other;
  const color = (family < 0 ? known.length + (hash(engine) % (colors - known.length)) : family) + 1;
  // An engine starts with the mark of its colour.
  const start = Math.max(0, family);
  return {
    color: `var(--engine-${color}${mark % 2 ? "-deep" : ""})`,
    symbol: symbols[(start + mark) % symbols.length] ?? "circle",
    dash: dashes[(start + mark) % dashes.length] ?? "",
  };
}
