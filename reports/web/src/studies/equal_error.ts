// How many times as long as the standard a method takes to be as accurate, over some of a study's cases.
import type { Engine } from "../model";
import type { SpeedCase } from "./speed_model";

export interface Factor {
  engine: Engine;
  median: number | null; // of those that get there; so the quartiles
  low: number | null;
  high: number | null;
  cases: number; // that were asked of it
  reached: number;
}

/** Between two neighbours where it falls between them, as in reports/statistics.cpp. */
function quantile(sorted: number[], share: number): number | null {
  const place = share * (sorted.length - 1);
  const below = sorted[Math.floor(place)];
  const above = sorted[Math.ceil(place)];
  return below === undefined || above === undefined ? null : below + (place % 1) * (above - below);
}

export function factors_over(cases: SpeedCase[]): Factor[] {
  const found = new Map<Engine, (number | null)[]>();
  for (const { curves } of cases) {
    for (const { engine, factor } of curves) found.set(engine, [...(found.get(engine) ?? []), factor]);
  }
  return [...found].map(([engine, factors]) => {
    const sorted = factors.filter((factor) => factor !== null).sort((a, b) => a - b);
    const at = (share: number): number | null => quantile(sorted, share);
    return { engine, median: at(0.5), low: at(0.25), high: at(0.75), cases: factors.length, reached: sorted.length };
  });
}
