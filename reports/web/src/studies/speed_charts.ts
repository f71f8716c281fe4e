// The charts of the speed study: error against time in a case, with the front of each method, and the time of each method
// at equal error over cases.
import * as Plot from "@observablehq/plot";
import { figure } from "../charts/figure";
import { decades, dot_look, error_axes, line_look, name_axis, plot_look, tip_look } from "../charts/look";
import { chosen, type Few } from "../chosen";
import { number, time_step } from "../format";
import { timed_label } from "../model";
import { target_name, type Factor, type SpeedCase, type SpeedMark } from "./speed_model";

const height = 460;

const run_text = ({ engine, setting, dt, time, error, wide }: SpeedMark): string =>
  [
    engine.label,
    [setting, `step ${time_step(dt)}`].filter(Boolean).join(", "),
    `${number(error, "m")} from the truth`,
    `${number(time * 1e6, "\u00b5s")} for a simulated second${wide ? ", unsteady" : ""}`,
  ].join("\n");

/** Error against time per simulated second; a click on a point calls `choose`. */
export function work_precision(item: SpeedCase, few: Few, targets: number[], choose: (mark: SpeedMark) => void): HTMLElement {
  const { front, truth_error } = item;
  const draw = (width: number) => {
    const [marks, curves] = [chosen(item.marks, few), chosen(item.curves, few)];
    const { x, y, floor } = error_axes(
      marks.map(({ error }) => error),
      marks.map(({ time }) => time * 1e6),
      "time per simulated second (\u00b5s), median",
      [truth_error],
    );
    const at = { x: ({ time }: SpeedMark) => time * 1e6, y: ({ error }: SpeedMark) => Math.max(error, floor) };
    const errors = marks.map(({ error }) => error);
    const crossed = targets.filter((target) => target >= Math.min(...errors) && target <= Math.max(...errors));
    const in_view = front.filter(({ error, time }) => marks.some((mark) => mark.error <= error || mark.time >= time));
    const chart = Plot.plot({
      ...plot_look(width, height),
      ariaLabel: "Error against time per simulated second",
      x,
      y,
      marks: [
        Plot.line(in_view, { ...at, clip: true, stroke: "var(--truth)", strokeWidth: 9, strokeLinecap: "round", strokeLinejoin: "round", className: "front" }),
        Plot.ruleY(crossed, { stroke: "var(--soft)", strokeOpacity: 0.6 }),
        Plot.text(crossed, { y: (target: number) => target, text: target_name, frameAnchor: "right", dy: -6, fill: "var(--soft)" }),
        truth_error > floor
          ? [
              Plot.ruleY([truth_error], { stroke: "var(--faint)", strokeDasharray: "4 3" }),
              Plot.text([truth_error], { y: (error: number) => error, text: () => "error of the reference", frameAnchor: "left", dx: 4, dy: -6, fill: "var(--faint)" }),
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
          { ...at, r: 7, stroke: "var(--faint)", strokeDasharray: "2 2", className: "unsteady", ariaDescription: "unsteady time" },
        ),
        Plot.tip(marks, Plot.pointer({ ...at, title: run_text, ...tip_look })),
      ],
    });
    chart.addEventListener("click", () => {
      const pointed = (chart as { value?: SpeedMark | null }).value;
      if (pointed) choose(pointed);
    });
    return chart;
  };
  const unsteady = item.marks.filter(({ wide }) => wide).length;
  return figure({
    title: "Error against time",
    note: `Lower is more accurate, further left is faster. A curve connects a method\u2019s best runs; small dots are its other runs. The broad band is the front of all methods.${unsteady ? " A dashed ring: the repetitions scatter." : ""}`,
    height,
    draw: (width) => [draw(width)],
  });
}

const row_height = 26;

const factor_text = ({ engine, median, low, high, reached, cases, fastest }: Factor): string =>
  [
    timed_label(engine),
    `${number(median, "", 2)} times the fastest, middle half ${number(low, "", 2)} to ${number(high, "", 2)}`,
    `gets there in ${reached} of ${cases} cases, the fastest in ${fastest}`,
  ].join("\n");

/** The time of each method over the fastest one's, to an error (`target`, as "1 mm"): median and middle half over cases; `over` names them, as "all cases". */
export function equal_error_chart(target: string, factors: Factor[], over: string): HTMLElement {
  const found = factors.filter(({ median }) => median !== null).sort((a, b) => b.reached - a.reached || (a.median ?? 0) - (b.median ?? 0));
  const never = factors.filter(({ median }) => median === null).map(({ engine }) => timed_label(engine));
  const height = 70 + row_height * found.length;
  const name = ({ engine, reached, cases }: Factor) => `${timed_label(engine)}  ${reached}/${cases}`;
  const draw = (width: number) => {
    const values = found.flatMap(({ low, high }) => [low ?? 1, high ?? 1]);
    const { domain, ticks } = decades([1, ...values]);
    const { marginLeft, axis } = name_axis(width, found.map(name));
    return Plot.plot({
      ...plot_look(width, height),
      marginLeft,
      ariaLabel: `Time to ${target}, the fastest = 1`,
      x: { type: "log", domain, ticks, label: `time to ${target}, the fastest = 1`, labelAnchor: "right", grid: true, tickFormat: (value: number) => number(value, "", 1) },
      y: { domain: found.map(name) },
      marks: [
        axis,
        Plot.ruleX([1], { stroke: "var(--faint)" }),
        Plot.link(found, { x1: "low", x2: "high", y1: name, y2: name, stroke: ({ engine }: Factor) => engine.color, strokeWidth: 3, strokeOpacity: 0.5 }),
        ...found.map((factor) =>
          Plot.dot([factor], { x: "median", y: name, r: 5, ...dot_look(factor.engine), className: "factor", ariaDescription: factor.engine.label }),
        ),
        Plot.tip(found, Plot.pointerY({ x: "median", y: name, title: factor_text, ...tip_look })),
      ],
    });
  };
  return figure({
    title: `Time to be within ${target} of the truth, over ${over}`,
    note: `Those that get there in most cases first (the numbers after the names). Marks are medians over the cases that a method reaches, bars the middle half.${never.length ? ` In no case: ${never.join(", ")}.` : ""}`,
    height,
    draw: (width) => (found.length ? [draw(width)] : []),
  });
}
