#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "reference/faults/altered_engine.h"
#include "reports/prove/detection.h"
#include "reports/run/experiment.h"

/// Measures whether verdicts mean something: no control may be right or plausible where mechanics moves otherwise.
namespace plumb {

/// What became of a control in a case.
///   truth, invariant  wrong, by a check that the right engine passes
///   same              not told from the right engine, and it moves like that one, as long as the motion is known: past
///                     the end of a case's converged reference no pose is right or wrong
///   inconclusive      moves otherwise, and is neither wrong nor passes: coarse, no evidence, or wrong only by checks
///                     that the right engine fails too
///   passes            moves otherwise, and is right or plausible: the verdict means nothing here
enum class Unmasking { truth, invariant, same, inconclusive, passes };

/// "truth", "invariant", "same", "inconclusive", "passes".
const char* name_of(Unmasking);

struct ControlRun {
  std::string scenario, variant;
  Unmasking unmasking = Unmasking::same;
  Verdict verdict = Verdict::right;
  double difference = 0;               // see `largest_difference`
  std::optional<Detection> detection;  // that with the largest ratio, if it is wrong by one
};

struct ControlResult {
  Control control;
  std::vector<ControlRun> runs;  // of the cases that our engine can run and is not wrong in

  std::size_t count(Unmasking) const;
  /// The run with the largest ratio; null if the control was never unmasked.
  const ControlRun* best() const;
};

/// All controls, judged by what one engine states of itself.
struct ControlReport {
  std::string stated;  // label of the engine, see label_of
  std::size_t cases = 0;
  std::size_t left_out = 0;  // of the cases: our engine can't run them, or is wrong there
  std::vector<ControlResult> results;

  std::size_t passes() const;
};

/// The largest difference of a pose, at any moment of `right` until that time, s, relative to the scale that `right`
/// gives it (see judge/scale.h). Infinite if the other run ends earlier, or if it reports no contacts where the case
/// asks about loads and `right` reports some.
double largest_difference(const Case&, const Trace& right, const Trace& other, double until);

/// Runs every control on every case, and judges each run by the statement of each engine. One report for each
/// statement. The result does not depend on `jobs`.
std::vector<ControlReport> prove_controls(const std::vector<Control>&, const std::vector<Case>&,
                                          const std::vector<EngineConfig>& stated, CaseTruths&, int jobs,
                                          const Progress&);

/// A summary line, a table of the controls with the best detection of each, and every pass. `each_case`: also what
/// became of every control in every case.
std::string text_of(const ControlReport&, bool each_case);

nlohmann::ordered_json to_json(const std::vector<ControlReport>&);

}  // namespace plumb
