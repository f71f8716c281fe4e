#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/judge/neighbours.h"
#include "reports/report.h"
#include "reports/trace.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// What an invariant may look at: the scene, the run, and what the engine states of its stepping.
struct InvariantContext {
  const Scene& scene;
  const Trace& trace;  // at least two moments
  const Stepping& stepping;
  Neighbours neighbours{scene, trace, stepping};
};

/// A physical law that holds in every scene it applies to, whether or not there is a closed form.
struct Invariant {
  std::string name;
  std::string unit;
  std::string definition;
  /// Returns nullopt if it does not apply to the scene.
  std::function<std::optional<InvariantCheck>(const InvariantContext&)> check;
};

/// Collects the violations of an invariant over a run and keeps the one with the largest error_ratio.
class WorstViolation {
 public:
  /// `scale` is what an engine without the law would show here, in the check's unit: 0 where nothing tests it. `where`
  /// is called only if this is the worst so far.
  template <class Where>
  void add(double value, double tolerance, double scale, double time, Where&& where) {
    test(tolerance, scale);
    const double ratio = error_ratio(value, tolerance);
    if (any_ && !(ratio > check_.ratio)) return;
    any_ = true;
    check_.value = value;
    check_.tolerance = tolerance;
    check_.ratio = ratio;
    check_.time = time;
    check_.where = where();
  }

  /// Held if nothing was added. Its scale stands to its tolerance as where the run tested the law best.
  InvariantCheck result() const;

 private:
  void test(double tolerance, double scale);

  bool any_ = false;
  InvariantCheck check_;
  double power_ = 0;  // the largest scale / tolerance
  double scale_ = 0;  // there
};

/// The result of an invariant that needs what the engine does not report.
InvariantCheck not_reported();

/// The result of an invariant of contacts, if they cannot judge it: not applicable where nothing touches, by the
/// scene's shapes, and otherwise not reported where the engine reports no contacts or, if `whole`, not all impulses of
/// a step. nullopt: they can.
std::optional<InvariantCheck> without_contacts(const InvariantContext&, bool whole);

/// Every invariant that applies, ordered by name; none for a trace of fewer than two moments.
std::vector<InvariantCheck> check_invariants(const InvariantContext&);

}  // namespace plumb
