// The study of models as its page thinks of it.
import type { Study } from "../data";

export interface Spread {
  median: number;
  low: number;
  high: number;
}

/** A feature dropped from the full model, alone. */
export interface Drop {
  feature: string;
  without: string;
  setting: string;
  within: boolean; // the tolerance
  change: number | null; // m, by which it is worse than the full model; null where it did not run
  why: string; // why it did not
  ratio: number | null; // of its cost to the full model's
}

export interface Least {
  line: string;
  error: number | null; // m
  change: number; // m
  cheaper: Spread; // times
  auto_cheaper: Spread;
  dropped: { feature: string; without: string }[];
}

export interface Chosen {
  line: string;
  within: boolean;
  change: number | null;
  choices: { setting: string; reason: string }[];
}

export interface ModelCase {
  scenario: string;
  variant: string;
  line: string; // the full model
  error: number | null; // m, its own
  cost: number | null; // s per simulated second
  duration: number; // s
  truth: string; // "" where there is none
  truth_until: number; // s
  compared_until: number; // s; 0 where the truth does without
  drops: Drop[];
  least: Least | null;
  chosen: Chosen | null;
}

export interface LeastModels {
  tolerance: string; // m, as it was given
  dt: string;
  cases: ModelCase[];
}

interface Values extends Omit<ModelCase, "cost" | "drops" | "least" | "chosen">, Omit<Drop, "ratio"> {
  role: "full" | "drop" | "auto" | "least";
  choices?: Chosen["choices"];
}

interface Costs {
  case: string;
  full: number | null;
  drops: { setting: string; ratio: number | null }[];
  least: Least | null;
}

export function least_models(study: Study): LeastModels {
  const all = study.results.filter(({ ending }) => ending === "done").map(({ values }) => values as unknown as Values);
  const costs = study.timings.cases as unknown as Costs[];
  const cases = costs.flatMap(({ case: place, full: cost, drops, least }): ModelCase[] => {
    const here = all.filter(({ scenario, variant }) => `${scenario}/${variant}` === place);
    const full = here.find(({ role }) => role === "full");
    if (!full) return [];
    const ratios = new Map(drops.map(({ setting, ratio }) => [setting, ratio]));
    const { scenario, variant, line, error, duration, truth, truth_until, compared_until } = full;
    return [
      {
        ...{ scenario, variant, line, error, duration, truth, truth_until, compared_until },
        cost,
        drops: here.filter(({ role }) => role === "drop").map((drop) => ({ ...drop, ratio: ratios.get(drop.setting) ?? null })),
        least,
        chosen: here.filter(({ role }) => role === "auto").map((own) => ({ ...own, choices: own.choices ?? [] }))[0] ?? null,
      },
    ];
  });
  return { tolerance: String(study.configuration.tolerance), dt: String(study.configuration.dt), cases };
}
