// Each method's factor of time at equal error: median and middle half over cases.
import * as Plot from "@observablehq/plot";
import { number } from "../format";
import type { Factor } from "../studies/equal_error";
import { decades } from "./decades";
import { figure } from "./figure";
import { dot_look, plot_look, tip_look } from "./look";
import { name_axis } from "./name_axis";

const row_height = 26;

const described = ({ engine, median, low, high, reached, cases }: Factor): string =>
  [
    engine.label,
    `${number(median, "", 2)} times, middle half ${number(low, "", 2)} to ${number(high, "", 2)}`,
    `gets there in ${reached} of ${cases} cases`,
  ].join("\n");

/** `over`: "all cases", or which. */
export function equal_error_chart(standard: string, factors: Factor[], over: string): HTMLElement {
  const found = factors.filter(({ median }) => median !== null).sort((a, b) => (a.median ?? 0) - (b.median ?? 0));
  const never = factors.filter(({ median }) => median === null).map(({ engine }) => engine.label);
  const height = 70 + row_height * found.length;
  const name = ({ engine, reached, cases }: Factor) => `${engine.label}  ${reached}/${cases}`;
  const draw = (width: number) => {
    const values = found.flatMap(({ low, high }) => [low ?? 1, high ?? 1]);
    const { domain, ticks } = decades([1, ...values]);
    const { marginLeft, axis } = name_axis(width, found.map(name));
    return Plot.plot({
      ...plot_look(width, height),
      marginLeft,
      ariaLabel: `Time at equal error, ${standard} = 1`,
      x: { type: "log", domain, ticks, label: `time at equal error, ${standard} = 1`, labelAnchor: "right", grid: true, tickFormat: (value: number) => number(value, "", 1) },
      y: { domain: found.map(name) },
      marks: [
        axis,
        Plot.ruleX([1], { stroke: "var(--faint)" }),
        Plot.link(found, { x1: "low", x2: "high", y1: name, y2: name, stroke: ({ engine }: Factor) => engine.color, strokeWidth: 3, strokeOpacity: 0.5 }),
        ...found.map((factor) =>
          Plot.dot([factor], { x: "median", y: name, r: 5, ...dot_look(factor.engine), className: "factor", ariaDescription: factor.engine.label }),
        ),
        Plot.tip(found, Plot.pointerY({ x: "median", y: name, title: described, ...tip_look })),
      ],
    });
  };
  return figure({
    title: `Time at equal error, over ${over}`,
    note: `Left of 1 is faster. Marks are medians over the cases, bars the middle half; the numbers say in how many cases the method gets as accurate.${never.length ? ` Never: ${never.join(", ")}.` : ""}`,
    height,
    draw: (width) => (found.length ? [draw(width)] : []),
  });
}
