// The axes of every chart of error against time, both logarithmic.
import { number } from "../format";
import { decades } from "./decades";

/** Smaller errors are round-off; they stand at the foot of the chart. */
const least_floor = 1e-12; // m

export interface ErrorAxes {
  x: object;
  y: object;
  floor: number; // m: errors below it are drawn there
}

/** For these errors (m), of which `lines` (m) are ruled across, and times (us). */
export function error_axes(errors: number[], times: number[], time_label: string, lines: number[] = []): ErrorAxes {
  const positive = errors.filter((error) => error > least_floor);
  const floor = positive.length ? 10 ** Math.floor(Math.log10(Math.min(...positive))) : least_floor;
  const foot = errors.some((error) => error < floor);
  const short = (value: number) => number(value, "", 1);
  return {
    x: { type: "log", label: time_label, labelAnchor: "right", grid: true, ...decades(times), tickFormat: short },
    y: {
      type: "log",
      label: "distance from the truth, RMS (m)",
      grid: true,
      ...decades([floor, ...positive, ...lines.filter((line) => line > floor)]),
      tickFormat: (value: number) => (value === floor && foot ? `\u2264 ${short(value)}` : short(value)),
    },
    floor,
  };
}
