#pragma once

#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "reports/report.h"

/// The results of runs that somebody has looked at and accepted. Later results are compared with them.
namespace plumb {

/// The bound of a number that may have any value, or be missing, on another platform.
constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Identifies a run within a baseline or a report.
struct RunKey {
  std::string scenario, variant, engine, method;

  /// "scenario variant, engine:method"
  std::string text() const;
  friend bool operator==(const RunKey&, const RunKey&) = default;
  friend bool operator<(const RunKey& a, const RunKey& b) {
    return std::tie(a.scenario, a.variant, a.engine, a.method) < std::tie(b.scenario, b.variant, b.engine, b.method);
  }
};

RunKey key_of(const RunRecord&);

/// One number of a run: the value of a metric, the error of a truth check, or how far an invariant is violated.
struct BaselineNumber {
  std::string unit;
  double value = 0;
  std::optional<CheckStatus> status = std::nullopt;  // of a check
  double tolerance = 0;                              // of a check
  /// How far from `value` the number may lie on another platform because of rounding (see bounds.h); `unbounded` if it
  /// may have any value or be missing, nullopt if the bound is not known.
  std::optional<double> bound = std::nullopt;
  bool unstable = false;  // perturbed runs had another status
  friend bool operator==(const BaselineNumber&, const BaselineNumber&) = default;
};

struct BaselineRun {
  bool exact = false;  // a closed form
  Verdict verdict = Verdict::plausible;
  std::string reason;                             // why it is not supported or failed
  std::string bits;                               // hash of the whole trace; "" without a trace
  std::set<Verdict> perturbed_verdicts;           // verdicts of perturbed runs, if there were any
  std::map<std::string, BaselineNumber> numbers;  // "energy_drift", "truth: y of box at 2 s", "invariant: cone"
};

struct Baseline {
  double dt = 0;                                // s
  bool all = false;                             // of all scenarios, not only the canonical ones
  std::vector<std::string> scenarios;           // that were asked for; empty for a whole set
  std::map<std::string, std::string> platform;  // what determines bits, see platform_of
  std::map<std::string, std::string> engines;   // source and version, by name
  std::map<std::string, std::string> words;     // how a command line names engines that have names of another kind
  std::map<RunKey, BaselineRun> runs;
  bool old_verdicts = false;  // accepted when *right* included what is now *coarse* or *no evidence*
  bool old_statuses = false;  // accepted when *not reported* included what is now *not applicable*
};

/// The entries of an environment that determine the bits of a result: architecture, compiler, flags and libm.
std::map<std::string, std::string> platform_of(const std::map<std::string, std::string>& environment);

/// The numbers of one run, without bounds, but for those that depend on a converged reference: how long it is valid may
/// differ from platform to platform, and with it when it is compared with.
BaselineRun baseline_run_of(const RunRecord&);

/// The same of the runs of a report, without converged references themselves.
Baseline baseline_of(const Report&);

/// Baselines as JSON files: sorted, with one line for each number, so that a diff shows the numbers that changed.

std::string to_text(const Baseline&);

/// Reads a baseline of this version or an older one. Throws std::invalid_argument, naming the file and the place in it,
/// if it cannot be read.
Baseline read_baseline(const std::string& path);

/// Reads a baseline or a report.json. A report has neither bits nor bounds, and its scenarios are exactly its cases.
/// Throws like read_baseline.
Baseline read_results(const std::string& path);

}  // namespace plumb
