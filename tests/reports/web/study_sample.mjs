// A small speed study with every feature.

const steps = [1 / 30, 1 / 60, 1 / 120];

/** Two engines in two cases, a third without results, and a job that crashed. */
export function study_sample() {
  const results = [];
  const times = {};
  const add = (scenario, engine, dt, error, time) => {
    const key = `speed|${scenario}/plain|${engine}|dt=${dt}`;
    const truth = scenario === "heap" ? "converged" : "fall";
    const common = { scenario, variant: "plain", engine, method: "", option: "substeps", setting: "4", standard: true, dt, order: 1 };
    results.push({ key, ending: "done", reason: "", values: { ...common, truth, truth_error: scenario === "heap" ? 1e-3 : 0, phases: 1, timed: 2, status: "ok", error } });
    times[key] = { median: time, low: time * 0.98, high: time * 1.02, repetitions: 5, wide: dt === steps[2] };
    return key;
  };
  const cases = ["fall", "heap"].map((scenario) => {
    const fronts = ["box2d", "impulse"].map((engine) =>
      steps.map((dt) => add(scenario, engine, dt, dt * (engine === "impulse" ? 0.1 : 1), (1e-5 / dt) * (engine === "impulse" ? 2 : 1))),
    );
    return {
      scenario,
      variant: "plain",
      scale: 2,
      front: fronts[1],
      engines: ["box2d", "impulse", "never"].map((engine, index) => ({
        engine,
        execution: engine === "box2d" ? "WebAssembly" : "native",
        front: fronts[index] ?? [],
        time_for_error: index < 2 ? [{ value: 3e-4, bound: true }, { value: 4e-4 * (2 - index), bound: false }, null] : [null, null, null],
        time_for_scale: index < 2 ? [{ value: 3e-4, bound: true }, null, null] : [null, null, null],
        least_error: index < 2 ? 2e-4 : null,
        error_for_time: [null, index < 2 ? { value: 2e-2, bound: false } : null],
      })),
    };
  });
  results.push({ key: "speed|heap/plain|<b>wild</b>|dt=1", ending: "crashed", reason: "ended by signal 11", values: {} });
  const order = { scenario: "fall", variant: "plain", option: "", setting: "", standard: true, points: 3 };
  return {
    study: {
      plumb: 2,
      study: "speed",
      about: "Speed against accuracy",
      configuration: { dt: ["1/30"], all: false },
      environment: { processor: "one" },
      results,
      findings: {
        order_tolerance: 0.2,
        failures: [{ engine: "<b>wild</b>", failed: 1, jobs: 1, first: "heap/plain", why: "crashed: ended by signal 11" }],
        orders: [
          { ...order, engine: "box2d", stated: 1, order: 1.01, half_width: 0.02, finding: "as stated" },
          { ...order, engine: "impulse", stated: 2, order: null, half_width: null, finding: "exact" },
          { ...order, engine: "impulse", scenario: "heap", stated: null, order: 0.5, half_width: 0.3, finding: "measured" },
        ],
      },
      timings: {
        results: times,
        error_targets: [1e-2, 1e-3, 1e-4],
        scale_targets: [1e-1, 1e-2, 1e-3],
        time_targets: [1e-5, 1e-3],
        cases,
      },
    },
  };
}
