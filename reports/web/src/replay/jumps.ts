// The moments worth seeing first.
import { number } from "../format";
import type { Case } from "../model";
import type { Film } from "./film";

export interface Jump {
  name: string;
  key: string;
  about: string;
  /** Of the films shown; undefined: there is no such moment. */
  find: (films: Film[]) => Found | undefined;
}

export interface Found {
  film: Film;
  time: number; // s
  text: string;
  body?: number;
}

const label_of = ({ run }: Film): string => (run.method ? `${run.engine}:${run.method}` : run.engine);

function largest(films: Film[], peak: (film: Film) => { time: number; value: number } | null): Found | undefined {
  let found: (Found & { value: number }) | undefined;
  for (const film of films) {
    const at = peak(film);
    if (at && (!found || at.value > found.value)) {
      found = { film, time: at.time, value: at.value, text: `${number(at.value, "m", 2)}, ${film.engine.label}` };
    }
  }
  return found;
}

export function jumps_of({ comparisons, entries }: Case): Jump[] {
  const reference = (entries.find(({ engine, run }) => engine.exact && run.status === "ok") ?? entries.find(({ run }) => run.status === "ok"))?.run;
  const name = reference ? (reference.method ? `${reference.engine}:${reference.method}` : reference.engine) : "";
  const parted = (film: Film): number | undefined => {
    const label = label_of(film);
    const pair = comparisons.find(({ a, b }) => label !== name && ((a === label && b === name) || (a === name && b === label)));
    return pair?.metrics["parted_at"]?.value ?? undefined;
  };
  const from = reference?.exact ? "the truth" : name;
  return [
    {
      name: "First divergence",
      key: "1",
      about: `when the first run shown is 1 cm (RMS over the bodies) from ${from}`,
      find: (films) => {
        let found: Found | undefined;
        for (const film of films) {
          const time = parted(film);
          if (time !== undefined && (!found || time < found.time)) found = { film, time, text: film.engine.label };
        }
        return found;
      },
    },
    {
      name: "Largest error",
      key: "2",
      about: `when a run shown is furthest from ${from} (RMS over the bodies)`,
      find: (films) => largest(films, ({ run }) => run.apart),
    },
    {
      name: "Worst overlap",
      key: "3",
      about: "when two bodies of a run shown reach deepest into each other, by the scene\u2019s geometry",
      find: (films) => {
        const found = largest(films, ({ run }) => run.overlap);
        const body = found?.film.run.overlap?.b;
        return found && body !== undefined ? { ...found, body } : found;
      },
    },
  ];
}
