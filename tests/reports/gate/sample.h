#pragma once

#include "reports/gate/baseline.h"

/// A small baseline of one run.
namespace plumb::fakes {

inline RunKey run_key(const std::string& engine = "impulse") { return {"bounce", "e=0.5", engine, ""}; }

inline Baseline baseline() {
  BaselineRun run{.verdict = Verdict::right, .bits = "00000000000000aa", .perturbed_verdicts = {Verdict::right}};
  run.numbers["penetration_max"] = {.unit = "m", .value = 1, .bound = 0.5};
  run.numbers["truth: y of box at 2 s"] = {
      .unit = "m", .value = 0.25, .status = CheckStatus::held, .tolerance = 0.5, .bound = 0.125};
  Baseline all{
      .dt = 1.0 / 64, .platform = {{"architecture", "one"}, {"libm", "this"}}, .engines = {{"impulse", "here"}}};
  all.runs[run_key()] = run;
  return all;
}

inline BaselineRun& run_of(Baseline& baseline) { return baseline.runs.begin()->second; }
inline BaselineNumber& metric_of(Baseline& baseline) { return run_of(baseline).numbers["penetration_max"]; }
inline BaselineNumber& check_of(Baseline& baseline) { return run_of(baseline).numbers["truth: y of box at 2 s"]; }

inline Baseline elsewhere(Baseline baseline) {
  baseline.platform["libm"] = "another";
  return baseline;
}

}  // namespace plumb::fakes
