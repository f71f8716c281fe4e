// What one reads first: the verdict in a sentence, and what it rests on.
import { h, svg } from "../dom";
import { count, enumerate, time_step } from "../format";
import type { Model } from "../model";
import { sentence } from "../verdict";

/** A plumb line. */
export function mark(): SVGElement {
  return svg(
    "svg",
    { viewBox: "0 0 24 72", width: 24, height: 72, class: "bob", "aria-hidden": "true" },
    svg("path", { d: "M12 0V40", class: "thread" }),
    svg("path", { d: "M12 40c4 0 7 3 7 8 0 7-4 14-7 22-3-8-7-15-7-22 0-5 3-8 7-8z", class: "weight" }),
  );
}

export function opening(model: Model): HTMLElement {
  const { report } = model.page;
  const cases = model.chapters.reduce((sum, chapter) => sum + chapter.cases.length, 0);
  const engines = model.engines.filter(({ exact }) => !exact).map(({ label }) => label);
  const steps = [...new Set(report.runs.filter(({ exact, dt }) => !exact && dt > 0).map(({ dt }) => time_step(dt)))];
  const basis = [
    `${count(model.chapters.length, "scenario")} in ${count(cases, "case")}`,
    engines.length ? enumerate(engines) : "",
    model.engines.some(({ exact }) => exact) ? "the closed form as truth" : "",
    steps.length ? `time step ${enumerate(steps)}` : "",
  ];
  return h(
    "header",
    { class: "opening" },
    mark(),
    h(
      "div",
      {},
      h("p", { class: "title" }, report.title || "Plumb report"),
      h("h1", {}, sentence(model)),
      h("p", { class: "basis" }, basis.filter(Boolean).join(" \u00b7 ")),
    ),
  );
}
