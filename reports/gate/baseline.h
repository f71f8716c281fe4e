#pragma once

#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "reports/report.h"

/// What runs came to when somebody last looked and said: so it shall be.
namespace plumb {

/// By how much a number may move where no bound is known: any amount.
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Who was asked what.
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

/// One number of a run: a metric's value, a truth check's error, by how much an invariant is missed.
struct KeptNumber {
  std::string unit;
  double value = 0;
  /// Of a check: whether it held, and how much it was allowed.
  std::optional<CheckStatus> status = std::nullopt;
  double tolerance = 0;
  /// How far from `value` another platform may find it by rounding (see bounds.h); infinite: it may as well be missing;
  /// nothing: not known.
  std::optional<double> moves = std::nullopt;
  bool wavers = false;  // starts next to this one stand otherwise
  friend bool operator==(const KeptNumber&, const KeptNumber&) = default;
};

struct KeptRun {
  bool exact = false;  // a closed form
  Verdict verdict = Verdict::plausible;
  std::string reason;                         // why not supported, or failed
  std::string bits;                           // of the whole trace, a hash; "" where there is none
  std::set<Verdict> neighbours;               // what starts next to this one came to, where that is known
  std::map<std::string, KeptNumber> numbers;  // by name: "energy_drift", "truth: y of box at 2 s", "invariant: cone"
};

struct Baseline {
  double dt = 0;                                // s
  bool all = false;                             // of every scenario, not only the canonical ones
  std::vector<std::string> words;               // the scenarios that were asked for; none: those of a set
  std::map<std::string, std::string> platform;  // what decides bits, see platform_of
  std::map<std::string, std::string> engines;   // where they come from, with version
  std::map<RunKey, KeptRun> runs;
};

/// Of an environment what decides the bits of a result: architecture, compiler and flags, and how libm computes.
std::map<std::string, std::string> platform_of(const std::map<std::string, std::string>& environment);

/// Every bit that a trace holds, as 16 hexadecimal digits.
std::string hash_of(const Trace&);

/// The numbers of one run, without how far they may move.
KeptRun kept(const RunRecord&);

/// Of a report as it stands in memory, without how far numbers may move.
Baseline baseline_of(const Report&);

}  // namespace plumb
