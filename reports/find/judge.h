#pragma once

#include <optional>

#include "reference/converged/converged.h"
#include "reports/find/complaint.h"
#include "reports/find/kind.h"
#include "reports/run/converged_checks.h"
#include "reports/run/run.h"

/// Judges an engine in a scene that nobody wrote expectations for.
namespace plumb {

/// s, the step of all runs of a search.
inline constexpr double search_step = 1.0 / 60;

/// Where every body must be, if that can be known: from a closed form that recognises the scene, or from refinement
/// that a second engine confirms.
class Known {
 public:
  /// The scene must outlive it. Nothing is known of scenes that are not well posed, and of those that would take more
  /// than a fraction of a second to refine.
  Known(const Scene&, Posed);

  /// The checks that this engine fails.
  std::vector<Complaint> complaints(const Stepping&, const Trace&) const;

 private:
  std::string judge_;
  std::optional<ConvergedTruth> truth_;
  std::optional<ConvergedChecks> checks_;
};

/// Runs the scene once and judges it by all that holds in such scenes: the run's end, the invariants and what is known.
Opinion judged(const Scene&, Posed, const EngineConfig&, const Known&);

}  // namespace plumb
