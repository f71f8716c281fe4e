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

/** By colour: the names of an engine, and methods of it that are shown often, with their marks. */
const known: Record<string, number>[] = [
  {
    "impulse": 0,
    "impulse:solver=article": 1,
    "impulse:solver=sequential-impulse": 2,
    "impulse:solver=split-impulse": 3,
    "impulse:solver=soft-step": 4,
    "impulse:solver=xpbd": 5,
    "impulse:solver=block": 6,
    "impulse:solver=exact": 7,
    "impulse:model=auto": 8,
    "impulse:precision=float": 9,
    "impulse:continuous=off": 10,
    "impulse:solver=exact,integrator=explicit-euler": 11,
    "impulse:solver=exact,integrator=rk4": 12,
    "impulse:solver=exact,integrator=velocity-verlet": 13,
  },
  { "box2d": 0, "box2d:restitution=0": 1, "box2d:continuous=off": 2 },
  { "chipmunk": 0, "chipmunk:slop=0.1": 1 },
  // Builds of one engine have its shape.
  { "box2d-v3": 0, "box2d3-wasm": symbols.length, "box2d3": 2 * symbols.length },
  { "rapier": 0 },
  { "planck": 0 },
  { "matter": 0 },
];
const first_other = 2 * symbols.length + 1;
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
  const family = known.findIndex((names) => Object.keys(names).some((name) => engine_of(name) === engine));
  const other = family < 0 ? hash(label) % marks : first_other + (hash(label) % (marks - first_other));
  const mark = known[family]?.[label] ?? other;
  const color = (family < 0 ? known.length + (hash(engine) % (colors - known.length)) : family) + 1;
  // An engine starts with the mark of its colour.
  const start = Math.max(0, family);
  return {
    color: `var(--engine-${color}${mark % 2 ? "-deep" : ""})`,
    symbol: symbols[(start + mark) % symbols.length] ?? "circle",
    dash: dashes[(start + mark) % dashes.length] ?? "",
  };
}
