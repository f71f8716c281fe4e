// The look of an engine: colour (a palette that is safe for colour-blind readers), shape and dash. An engine looks the
// same in every report, whatever else is in it: known names have a place of their own, others get one from their letters.

export interface Look {
  color: string;
  symbol: string;
  dash: string;
}

const symbols = ["circle", "square", "triangle", "diamond", "wye", "star"];
const dashes = ["", "7 3", "2 3", "9 3 2 3", "12 4", "4 2"];
const colors = 6;
const places = 36; // that differ

/** In the order of their places: engines have the six colours first, methods of ours come next. */
const known = [
  "impulse",
  "box2d",
  "chipmunk",
  "box2d3",
  "rapier",
  "planck",
  "matter",
  "impulse:solver=sequential-impulse",
  "impulse:solver=split-impulse",
  "impulse:solver=article",
  "impulse:solver=xpbd",
  "impulse:solver=soft-step",
  "impulse:solver=block",
  "impulse:solver=exact",
  "chipmunk:slop=0.1",
];

function look(place: number): Look {
  const offset = place + Math.floor(place / colors);
  return {
    color: `var(--engine-${(place % colors) + 1})`,
    symbol: symbols[offset % symbols.length] ?? "circle",
    dash: dashes[offset % dashes.length] ?? "",
  };
}

/** FNV-1a */
function hash(text: string): number {
  let value = 0x811c9dc5;
  for (const letter of text) value = Math.imul(value ^ (letter.codePointAt(0) ?? 0), 0x01000193) >>> 0;
  return value;
}

/** The looks of engines that are shown together: all differ, up to 36. Names that want the same place share it out in alphabetical order. */
export function looks(labels: string[]): (label: string) => Look {
  const found = new Map<string, Look>();
  const taken = new Set<number>();
  const free = places - known.length;
  for (const label of [...new Set(labels)].sort()) {
    let place = known.indexOf(label);
    if (place < 0) {
      place = known.length + (hash(label) % free);
      // The next free place, at last one of a known engine that is not here.
      const here = (one: number): boolean => taken.has(one) || labels.includes(known[one] ?? "");
      for (let tries = 0; taken.has(place) && tries < free; ++tries) place = place + 1 < places ? place + 1 : known.length;
      for (let tries = 0; here(place) && tries < places; ++tries) place = (place + 1) % places;
    }
    taken.add(place);
    found.set(label, look(place));
  }
  return (label) => found.get(label) ?? look(0);
}
