#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/report.h"
#include "reports/trace.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// What an invariant may look at: the question, what came of it, and how the engine says it steps.
struct InvariantContext {
  const Scene& scene;
  const Trace& trace;  // two moments at least
  const Stepping& stepping;
};

/// Collects how far an invariant is missed, moment by moment, and keeps the one that is worst against what is allowed
/// there.
class Worst {
 public:
  /// `where` is only asked for when this is the worst so far. What is not finite is worse than anything that is.
  template <class Where>
  void see(double value, double allowed, double time, Where&& where) {
    const double ratio = times_allowed(value, allowed);
    if (seen_ && !(ratio > check_.ratio)) return;
    seen_ = true;
    check_.value = value;
    check_.tolerance = allowed;
    check_.ratio = ratio;
    check_.time = time;
    check_.where = where();
  }

  /// Nothing was seen: nothing was missed.
  InvariantCheck result() const;

  /// 0 where nothing is missed, infinity where nothing is allowed.
  static double times_allowed(double value, double allowed);

 private:
  bool seen_ = false;
  InvariantCheck check_;
};

/// Something that holds whatever the scene: the truth where there is no closed form, and where there is one, too.
struct Invariant {
  std::string name;
  std::string unit;
  std::string definition;
  /// Nothing where it does not apply to the scene.
  std::function<std::optional<InvariantCheck>(const InvariantContext&)> check;
};

/// What an invariant says that needs contacts of a run that shows none.
InvariantCheck not_reported();

/// Whether the engine showed a contact at any moment.
bool reports_contacts(const Trace&);

/// "a" or "a - b", by the names of the scene.
std::string pair_name(const Scene&, std::size_t a, std::size_t b);

/// Every invariant that applies, in order of names. A trace of fewer than two moments says nothing.
std::vector<InvariantCheck> check_invariants(const InvariantContext&);

}  // namespace plumb
