// Error against time per simulated second, one curve a method: the best that it gives for each time.
import * as Plot from "@observablehq/plot";
import { number, time_step } from "../format";
import type { SpeedCase, SpeedMark } from "../studies/speed_model";
import { error_axes } from "./error_axes";
import { figure } from "./figure";
import { dot_look, line_look, plot_look, tip_look } from "./look";

const height = 460;

const described = ({ engine, setting, dt, time, error, wide }: SpeedMark): string =>
  [
    engine.label,
    [setting, `step ${time_step(dt)}`].filter(Boolean).join(", "),
    `${number(error, "m")} from the truth`,
    `${number(time * 1e6, "\u00b5s")} for a simulated second${wide ? ", unsteady" : ""}`,
  ].join("\n");

/** `choose` is told of the point that is clicked. */
export function work_precision(place: SpeedCase, choose: (mark: SpeedMark) => void): HTMLElement {
  const { marks, curves, front, truth_error } = place;
  const { x, y, floor } = error_axes(
    marks.map(({ error }) => error),
    marks.map(({ time }) => time * 1e6),
    "time per simulated second (\u00b5s), median",
    [truth_error],
  );
  const at = { x: ({ time }: SpeedMark) => time * 1e6, y: ({ error }: SpeedMark) => Math.max(error, floor) };
  const draw = (width: number) => {
    const chart = Plot.plot({
      ...plot_look(width, height),
      ariaLabel: "Error against time per simulated second",
      x,
      y,
      marks: [
        Plot.line(front, { ...at, stroke: "var(--truth)", strokeWidth: 9, strokeLinecap: "round", strokeLinejoin: "round", className: "front" }),
        truth_error > floor
          ? [
              Plot.ruleY([truth_error], { stroke: "var(--faint)", strokeDasharray: "4 3" }),
              Plot.text([truth_error], { y: (error: number) => error, text: () => "the reference's own error", frameAnchor: "right", dy: -6, fill: "var(--faint)" }),
            ]
          : null,
        Plot.dot(
          marks.filter(({ on_front }) => !on_front),
          { ...at, r: 1.5, fill: ({ engine }: SpeedMark) => engine.color, fillOpacity: 0.45, ariaHidden: "true" },
        ),
        ...curves.map(({ engine, front: own }) =>
          Plot.line(own, { ...at, ...line_look(engine), className: "line", ariaDescription: engine.label }),
        ),
        ...curves.map(({ engine, front: own }) => Plot.dot(own, { ...at, r: 4, ...dot_look(engine), ariaHidden: "true" })),
        Plot.dot(
          marks.filter(({ wide, on_front }) => wide && on_front),
          { ...at, r: 7, stroke: "var(--faint)", strokeDasharray: "2 2", className: "unsteady", ariaDescription: "time not steady" },
        ),
        Plot.tip(marks, Plot.pointer({ ...at, title: described, ...tip_look })),
      ],
    });
    chart.addEventListener("click", () => {
      const pointed = (chart as { value?: SpeedMark | null }).value;
      if (pointed) choose(pointed);
    });
    return chart;
  };
  const unsteady = marks.filter(({ wide }) => wide).length;
  return figure({
    title: "Error against time",
    note: `Lower is more accurate, further left is faster. A curve joins a method\u2019s best runs; small dots are its others. The broad band is the front of all.${unsteady ? " A broken ring: repetitions did not agree on the time." : ""}`,
    height,
    draw: (width) => [draw(width)],
  });
}
