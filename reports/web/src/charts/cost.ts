// Error against cost, with one mark for each run.
import * as Plot from "@observablehq/plot";
import { number, time_step } from "../format";
import { timed_label, unlike, type Entry, type Model } from "../model";
import { figure } from "./figure";
import { dot_look, error_axes, plot_look, tip_look } from "./look";

const metric = "truth_error_rms";

interface Mark {
  entry: Entry;
  name: string; // of the case
  cost: number;
  low: number;
  high: number;
  error: number;
}

function marks_of(model: Model): Mark[] {
  const found: Mark[] = [];
  for (const chapter of model.chapters) {
    for (const { scenario, variant, entries } of chapter.cases) {
      for (const entry of entries) {
        const cost = entry.timing?.step_us;
        const error = entry.run.metrics[metric]?.value;
        if (entry.engine.exact || !cost || typeof error !== "number") continue;
        found.push({
          entry,
          name: `${scenario}, ${variant}`,
          cost,
          low: entry.timing?.step_us_low || cost,
          high: entry.timing?.step_us_high || cost,
          error,
        });
      }
    }
  }
  return found;
}

const described = ({ entry, name, cost, error }: Mark): string =>
  [
    timed_label(entry.engine),
    name,
    `${number(error, "m")} from the truth`,
    `${number(cost, "\u00b5s")} a step of ${time_step(entry.run.dt)}`,
  ].join("\n");

export function cost_chart(model: Model): HTMLElement | null {
  const marks = marks_of(model); // of the engines that the view chooses
  if (!marks.length) return null;
  const { x, y, floor } = error_axes(
    marks.map(({ error }) => error),
    marks.flatMap(({ low, high }) => [low, high]),
    "time per step (\u00b5s), median",
  );
  const height_of = ({ error }: Mark) => Math.max(floor, error);
  const by_engine = model.engines.map((engine) => marks.filter(({ entry }) => entry.engine === engine));
  const draw = (width: number) =>
    Plot.plot({
      ...plot_look(width, 400),
      ariaLabel: "Error against cost of every run",
      x,
      y,
      marks: [
        Plot.line(marks, { x: "cost", y: height_of, z: "name", stroke: "var(--faint)", strokeOpacity: 0.35 }),
        Plot.link(marks, {
          x1: "low",
          x2: "high",
          y1: height_of,
          y2: height_of,
          stroke: ({ entry }: Mark) => entry.engine.color,
          strokeOpacity: 0.5,
        }),
        ...by_engine.flatMap((own) =>
          own.slice(0, 1).map(({ entry }) =>
            Plot.dot(own, {
              x: "cost",
              y: height_of,
              r: 5,
              ...dot_look(entry.engine),
              className: "marks",
              ariaDescription: entry.engine.label,
            }),
          ),
        ),
        Plot.tip(marks, Plot.pointer({ x: "cost", y: height_of, title: described, ...tip_look })),
      ],
    });
  return figure({
    title: "Error against cost, every run",
    note: "Lower is more accurate, further left is faster. Thin lines connect the engines of a case; bars span the middle half of the repetitions. " + unlike(marks.map(({ entry }) => entry.engine)),
    height: 400,
    draw: (width) => [draw(width)],
  });
}
