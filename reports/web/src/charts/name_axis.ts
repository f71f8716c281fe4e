// The axis of a chart whose rows have names: as wide as the longest needs, and no wider than half of the chart, for which
// longer ones lose their middle.
import * as Plot from "@observablehq/plot";
import { scale } from "./look";

const letter = 6.6; // px, about
const type = 12.3; // px
const ticks = 24; // px, beside the names

export function name_axis(width: number, names: string[]): { marginLeft: number; axis: Plot.Markish } {
  const longest = Math.max(0, ...names.map((name) => name.length));
  const marginLeft = Math.min(width / 2, (ticks + longest * letter) * scale());
  const lineWidth = (marginLeft / scale() - ticks / 2) / type;
  return { marginLeft, axis: Plot.axisY({ label: null, lineWidth, textOverflow: "ellipsis-middle" }) };
}
