// The findings of the model study, as its view uses them.
import type { Study } from "../data";

export interface Spread {
  median: number;
  low: number;
  high: number;
}

/** The full model without one feature. */
export interface Drop {
  feature: string;
  without: string;
  setting: string;
  within: boolean; // within the tolerance
  change: number | null; // m, error added to the full model's; null if it did not run
  different?: string; // chaotic scenes: the statistics in which it differs from the full model
  breaks?: string; // the laws and truths that it breaks and the full model does not
  why: string; // why it did not run
  ratio: number | null; // of its cost to the full model's
}

export interface Least {
  line: string;
  error: number | null; // m
  change: number; // m
  cheaper: Spread; // cost of the full model / its own
  auto_cheaper: Spread | null; // null: not timed
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
  truth: string; // "" if there is none
  truth_until: number; // s
  compared_until: number; // s, of the comparison with the full model; 0 if the truth is enough
  chaotic?: boolean; // judged by statistics
  drops: Drop[];
  least: Least | null;
  complete: boolean; // the search for the least model came to its end
  why: string; // why there is no least model, or ""
  coarser: Coarser[];
  chosen: Chosen | null;
}

/** The cheapest model without one feature, if that much may be lost. */
export interface Coarser {
  tolerance: number; // m
  line: string;
  cheaper: number;
  change: number; // m
}

export interface LeastModels {
  tolerance: string; // m, as entered
  dt: string;
  cases: ModelCase[];
}

interface Values extends Omit<ModelCase, "cost" | "drops" | "least" | "complete" | "why" | "coarser" | "chosen">, Omit<Drop, "ratio"> {
  role: "full" | "drop" | "auto" | "least";
  choices?: Chosen["choices"];
}

interface Costs {
  case: string;
  full: number | null;
  drops: { setting: string; ratio: number | null }[];
  least: Least | null;
  complete?: boolean;
  why?: string;
  coarser?: Coarser[];
}

export function least_models(study: Study): LeastModels {
  const all = study.results.filter(({ ending }) => ending === "done").map(({ values }) => values as unknown as Values);
  const costs = study.timings.cases as unknown as Costs[];
  const cases = costs.flatMap(({ case: item, full: cost, drops, least, complete, why, coarser }): ModelCase[] => {
    const here = all.filter(({ scenario, variant }) => `${scenario}/${variant}` === item);
    const full = here.find(({ role }) => role === "full");
    if (!full) return [];
    const ratios = new Map(drops.map(({ setting, ratio }) => [setting, ratio]));
    const { scenario, variant, line, error, duration, truth, truth_until, compared_until, chaotic } = full;
    return [
      {
        ...{ scenario, variant, line, error, duration, truth, truth_until, compared_until, chaotic: chaotic ?? false },
        complete: complete ?? true,
        why: why ?? "",
        coarser: coarser ?? [],
        cost,
        drops: here.filter(({ role }) => role === "drop").map((drop) => ({ ...drop, ratio: ratios.get(drop.setting) ?? null })),
        least,
        chosen: here.filter(({ role }) => role === "auto").map((own) => ({ ...own, choices: own.choices ?? [] }))[0] ?? null,
      },
    ];
  });
  return { tolerance: String(study.configuration.tolerance), dt: String(study.configuration.dt), cases };
}
