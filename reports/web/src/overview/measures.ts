// What a cell of the overview may tell of a run beside its verdict.
import type { Child } from "../dom";
import { h } from "../dom";
import { number, share } from "../format";
import type { Entry } from "../model";
import { gauge } from "../sections/pieces";

export interface Measure {
  name: string;
  about: string;
  of: (entry: Entry) => number; // NaN: none
  shown: (entry: Entry) => Child;
}

const plain = (value: (entry: Entry) => number | null | undefined, unit: string): Pick<Measure, "of" | "shown"> => ({
  of: (entry) => value(entry) ?? NaN,
  shown: (entry) => {
    const found = value(entry);
    return typeof found === "number" ? h("span", {}, number(found, unit)) : null;
  },
});

const largest_miss: Measure = {
  name: "largest miss",
  about: "Each number is the largest miss of a run, of the truth or of what holds in any case, as a share of what is allowed there; the tick on the bar is the limit.",
  of: ({ run, worst }) => (run.status === "failed" ? Infinity : worst),
  shown: ({ worst }) => (Number.isNaN(worst) ? null : h("span", { class: "share" }, gauge(worst), share(worst))),
};

/** The first is shown unless another is asked for. */
export const measures: readonly [Measure, ...Measure[]] = [
  largest_miss,
  {
    name: "distance from the truth",
    about: "Each number is the distance of a run\u2019s bodies from the truth, root mean square over bodies and time.",
    ...plain(({ run }) => run.metrics["truth_error_rms"]?.value, "m"),
  },
  {
    name: "time per step",
    about: "Each number is the time that the engine\u2019s own step takes: the median over the repetitions.",
    ...plain(({ timing }) => timing?.step_us, "\u00b5s"),
  },
  {
    name: "real-time factor",
    about: "Each number is how many seconds are simulated for each second spent in steps.",
    ...plain(({ timing }) => timing?.real_time_factor, ""),
  },
];
