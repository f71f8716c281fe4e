// The part of a report that a view asks for: by engine, method, scenario and verdict. What is not chosen from is whole.
import type { View } from "./address";
import type { Case, Chapter, Engine, Model } from "./model";

/** Verdicts that a case may be asked for by: that of one of its engines. */
export const troubles: Record<string, (place: Case) => boolean> = {
  "something is wrong": ({ entries }) => entries.some(({ run }) => run.verdict === "wrong" || run.verdict === "failed"),
  "all is right": ({ entries }) => entries.every(({ run, engine }) => engine.exact || run.verdict === "right"),
  "engines differ": ({ entries }) => new Set(entries.filter(({ engine }) => !engine.exact).map(({ run }) => run.verdict)).size > 1,
  "something is not supported": ({ entries }) => entries.some(({ run }) => run.verdict === "not supported"),
};

export function chosen(view: View, { engine, method, exact }: Engine): boolean {
  const among = (key: string, value: string): boolean => !view.has(key) || view.getAll(key).includes(value);
  return exact || (among("engine", engine) && among("method", method));
}

export function matching(view: View, { scenario, variant }: { scenario: string; variant: string }): boolean {
  const words = view.get("scenario") ?? "";
  const text = `${scenario} ${variant}`.toLowerCase();
  return words.toLowerCase().split(/\s+/).every((word) => text.includes(word));
}

export function narrowed(model: Model, view: View): Model {
  const engines = model.engines.filter((engine) => chosen(view, engine));
  const trouble = troubles[view.get("verdict") ?? ""] ?? (() => true);
  const chapters = model.chapters.flatMap((chapter): Chapter[] => {
    const cases = chapter.cases
      .filter((place) => matching(view, place))
      .map((place) => ({ ...place, entries: place.entries.filter(({ engine }) => engines.includes(engine)) }))
      .filter((place) => place.entries.some(({ engine }) => !engine.exact) && trouble(place));
    return cases.length ? [{ ...chapter, cases }] : [];
  });
  return { ...model, engines, chapters };
}
