// A small report in the form that the C++ side writes: two free falls with known errors, and one case of every other kind
// (wrong, failed, not supported, no truth).
import { pack, replay_run } from "./pack.mjs";

const steps = 120;
const dt = 1 / 60;
const g = 10;

const times = Array.from({ length: steps + 1 }, (_, i) => i * dt);
const engines = [
  { engine: "impulse", method: "", exact: false, off: 0.5, cost: 0.4 },
  { engine: "box2d", method: "", exact: false, off: -0.5, cost: 0.7 },
  { engine: "free fall", method: "", exact: true, off: 0, cost: 0.01 },
];

function fall(height, engine) {
  const at = (t) => height - (g * t * t) / 2 - engine.off * g * t * dt;
  const error = Math.abs(engine.off) * g * 2 * dt;
  const check = {
    body: "ball",
    quantity: "y",
    unit: "m",
    time: 2,
    expected: height - 2 * g,
    measured: at(2),
    error,
    tolerance: error * 1.25 + 1e-9,
    ratio: error / (error * 1.25 + 1e-9),
    relative_error: error / (2 * g),
    evidence: true,
    relation: "equal",
    passed: true,
    reported: true,
    source: "h - g t^2/2; symplectic Euler is off by g t dt/2",
  };
  return {
    metrics: { truth_error_rms: { value: error / 1.7, unit: "m" }, energy_rise: { value: 0, unit: "J" } },
    truth: engine.exact ? [] : [check],
    invariants: [
      { name: "energy", unit: "J", status: "held", value: 0.1, tolerance: 0.4, ratio: 0.25, evidence: true, time: 1.5, where: "" },
      { name: "bouncing", unit: "m/s", status: "not applicable", value: 0, tolerance: 0, ratio: 0, evidence: false, time: 0, where: "" },
      { name: "push", unit: "N s", status: "not reported", value: 0, tolerance: 0, ratio: 0, evidence: false, time: 0, where: "" },
    ],
    series: {
      t: times,
      energy: times.map((t) => g * height + engine.off * g * t),
      momentum_x: times.map(() => 0),
      momentum_y: times.map((t) => -g * t),
      angular_momentum: times.map(() => 0),
      fastest: times.map((t) => g * t),
      pose_difference: times.map((t) => Math.abs(engine.off) * g * t * dt),
      overlap: times.map(() => 0),
    },
  };
}

/** A ball of radius 0.5 m above the ground, with a contact for three steps on its way. */
function replay_of(height, { engine, off }) {
  const y = (t) => height - (g * t * t) / 2 - off * g * t * dt;
  const contact = [{ begin: 30, points: [30, 31, 32].map((i) => [0.5, y(times[i]), -1, 0.5]) }];
  return replay_run({
    engine,
    times,
    states: times.map((t) => [[0, y(t), 2 * t], [0, -100, 0]]),
    energies: times.map((t) => [(g * t) ** 2 / 2, 0.1, g * y(t)]),
    places: off > 0 ? [contact] : [],
    steps: { length: 1 / 2048, angle: 1 / 1024, impulse: 1 / 512, energy: 1 / 16 },
    apart: off ? { time: 2, value: Math.abs(off) * g * 2 * dt } : null,
    overlap: off > 0 ? { time: 0.5, value: 0.01, a: 0, b: 1 } : null,
  });
}

export const ball = { y: (height, off, t) => height - (g * t * t) / 2 - off * g * t * dt, radius: 0.5 };

const scene = {
  outlines: [{ points: [[0, 0]], radius: ball.radius }, { normal: [0, 1], offset: 0 }],
  bodies: [
    { name: "ball", type: "dynamic", outlines: [0] },
    { name: "ground", type: "fixed", outlines: [1] },
  ],
  joints: [],
};

const run_of = (scenario, variant, { engine, method }) => ({ scenario, variant, engine, method });

const none = { largest: 0, end: 0 };
const key_differences = (found) => ({ energy: none, momentum: none, angular_momentum: none, rest_a: null, rest_b: null, overlap_a: 0, overlap_b: 0, diverged_at: null, ...found });

/** The data of the page; `scenario` is the name of the first scenario. */
export function sample(scenario = "free-fall") {
  const page = {
    report: {
      plumb: 4,
      title: "Canonical scenarios",
      command: ["./plumb", "report"],
      environment: { compiler: "GCC 12.2.0", build: "Release", box2d: "2.4.1" },
      scenarios: [
        {
          name: scenario,
          question: "Does a lone ball fall as Galileo says?",
          parameters: [{ name: "height", unit: "m", about: "above the ground at the start" }],
        },
      ],
      engines: [
        { name: "impulse", about: "our own engine", source: "engine/", word: "", language: "C++", execution: "native", exact: false, caveats: ["sinks <b>in</b>"] },
        { name: "box2d", about: "Box2D", source: "box2d.org", word: "exec:node my box2d.mjs", language: "C", execution: "WebAssembly", exact: false, states: [{ method: "", text: "first order" }] },
      ],
      metrics: [{ name: "truth_error_rms", unit: "m", definition: "RMS distance of the bodies from the closed form" }],
      invariants: [{ name: "energy", unit: "J", definition: "never rises without work" }],
      runs: [],
      comparisons: [],
      timings: { steps: [], clock: { runs_s: 3.2, outside_step: 0.31 } },
    },
    series: [],
    replays: [],
    studies: [],
  };
  const { report } = page;
  for (const height of [5, 50]) {
    const variant = `height ${height}`;
    for (const engine of engines) {
      const { series, ...result } = fall(height, engine);
      const of = run_of(scenario, variant, engine);
      report.runs.push({ ...of, parameters: { height }, exact: engine.exact, dt, status: "ok", reason: "", ...result, verdict: "right" });
      page.series.push({ ...of, ...series });
      if (engine.exact) continue;
      const cost = { step_us: engine.cost * height ** 0.2, step_us_low: engine.cost, step_us_high: engine.cost * 2 };
      report.timings.steps.push({ ...of, ...cost, real_time_factor: 40000, repetitions: 5 });
    }
    page.replays.push({ scenario, variant, scene: pack(JSON.stringify(scene)), runs: engines.map((engine) => replay_of(height, engine)) });
    report.comparisons.push({
      scenario,
      variant,
      a: "impulse",
      b: "box2d",
      key_differences: key_differences({ energy: { largest: 0.023, end: 0.0004 }, rest_a: 1.25, overlap_b: 0.0034, diverged_at: 0.25 }),
      metrics: { pose_difference_end: { value: 0.333, unit: "m" } },
      verdict: "plausible",
      reason: "",
    });
  }
  for (const { scenario, variant } of page.replays) {
    const key = key_differences({ energy: { largest: 0.5, end: 0.5 }, rest_a: 1.25, rest_b: 1.5, diverged_at: 0.25 });
    report.comparisons.push({ scenario, variant, a: "impulse", b: "free fall", key_differences: key, metrics: {}, verdict: "right", reason: "" });
  }
  const other = { parameters: { boxes: 10 }, exact: false, dt, metrics: {}, truth: [], invariants: [] };
  const wrong = { body: "box 10", quantity: "x", unit: "m", time: 10, expected: 0, measured: 0.42, error: 0.42, tolerance: 0.13, ratio: 0.42 / 0.13, relative_error: 0.42, evidence: false, relation: "equal", passed: false, reported: true, source: "nothing moves" };
  report.runs.push(
    { ...other, ...run_of("stacking", "10 boxes", engines[0]), status: "ok", reason: "", verdict: "wrong", truth: [wrong] },
    { ...other, ...run_of("stacking", "10 boxes", engines[1]), status: "failed", reason: "diverged at t = 0.42 s", verdict: "failed" },
    { ...other, ...run_of("stacking", "tilted", engines[0]), status: "ok", reason: "", verdict: "plausible" },
    { ...other, ...run_of("stacking", "tilted", engines[1]), status: "not supported", reason: "has one friction coefficient only", verdict: "not supported" },
  );
  return page;
}

/** A report with many cases: copies of a chapter of the sample. */
export function long_sample() {
  const data = sample();
  const { report } = data;
  const [first] = report.scenarios;
  const copies = ["runs", "comparisons"].map((name) => [report, name]);
  for (const [of, name] of [...copies, [report.timings, "steps"], [data, "series"], [data, "replays"]]) {
    const own = of[name].filter(({ scenario }) => scenario === first.name);
    for (let k = 0; k < 20; ++k) of[name].push(...own.map((one) => ({ ...one, scenario: `${first.name}-${k}` })));
  }
  for (let k = 0; k < 20; ++k) report.scenarios.push({ ...first, name: `${first.name}-${k}`, group: k % 2 ? "odd" : "even" });
  return data;
}
