// The command line of every run in a work-precision diagram: of the point that is clicked, and all of them as a table.
import { h, table } from "../dom";
import { folded } from "../folded";
import { number, step_word, time_step } from "../format";
import { command, copy, copy_button, run_command } from "../sections/command";
import type { SpeedCase, SpeedMark } from "./speed_model";

function line_of(place: SpeedCase, { engine, setting, dt }: SpeedMark): string {
  const { scenario, variant, truth } = place;
  return run_command({ scenario, variant, engine: engine.label, setting, dt: step_word(dt), converged: truth === "converged" });
}

/** Where the line of the chosen point stands, and what puts it there and on the clipboard. */
export function chosen_run(place: SpeedCase): { element: HTMLElement; choose: (mark: SpeedMark) => void } {
  const element = h("div", { class: "chosen" }, h("p", { class: "basis" }, "A click on a point copies the command line that runs it."));
  const choose = (mark: SpeedMark): void => {
    const line = line_of(place, mark);
    const said = h("p", { class: "basis", role: "status" }, `${mark.engine.label}, step ${time_step(mark.dt)}`);
    element.replaceChildren(said, command(line));
    void copy(line).then((copied) => copied && said.append(": copied"));
  };
  return { element, choose };
}

/** Broken between words only, if at all: a line that ends with "--" would be typed wrong. */
function on_paper(line: string): HTMLElement {
  return h("code", { class: "on-paper" }, ...line.split(" ").flatMap((word) => [h("span", {}, word), " "]));
}

function row(place: SpeedCase, mark: SpeedMark): HTMLTableRowElement {
  const line = line_of(place, mark);
  const cells: [string, string | Node][] = [
    ["setting", mark.setting || "\u2013"],
    ["step", time_step(mark.dt)],
    ["error", number(mark.error, "m", 2)],
    ["time for a second", number(mark.time * 1e6, "\u00b5s")],
    ["command line", h("span", {}, on_paper(line), copy_button(line))],
  ];
  return h("tr", {}, h("th", { scope: "row" }, mark.engine.label), ...cells.map(([head, cell]) => h("td", { "data-label": head }, cell)));
}

export function all_runs(place: SpeedCase): HTMLElement {
  return folded(`All ${place.marks.length} runs, and the line that makes each`, () => {
    const marks = [...place.marks].sort((a, b) => a.engine.label.localeCompare(b.engine.label) || a.time - b.time);
    const heads = ["method", "setting", "step", "distance from the truth, RMS", "time for a simulated second", "command line"];
    return [table("Runs of this case", heads, marks.map((mark) => row(place, mark)), "numbers")];
  });
}
