#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reports/compare/tolerance.h"
#include "reports/trace.h"
#include "scenarios/scenario.h"

/// Why two runs of one scene diverge in a step, as far as their contacts show it.
namespace plumb {

/// The part of a step in which two runs first differ.
enum class Stage {
  start,        // before the first step
  integration,  // nothing touches the body in either run
  event_time,   // one run has an impact that the other has some steps later, or at another moment of the step
  contact_set,  // two bodies touch in one run only
  manifold,     // the same bodies touch, at other points, normals or separations
  impulse,      // the same contacts have other impulses
  not_reported  // the reported contacts do not explain it
};

/// "start", "integration", "event time", "contact set", "manifold", "impulse", "not reported".
const char* name_of(Stage);

/// One of the two runs that are compared, and what its engine states of its stepping. The trace must outlive it.
struct ComparedRun {
  std::string name;
  const Trace* trace = nullptr;
  Stepping stepping;
};

/// One quantity in both runs.
struct ValueDifference {
  std::string what;  // "y of box"
  std::string unit;
  std::optional<double> a, b;  // nullopt if that run does not report it
  double difference = 0;       // |a - b|
  double tolerance = 0;        // up to which they count as equal
};

struct ContactCause {
  Stage stage = Stage::integration;
  std::string other;  // the body at the contact that explains the divergence; "" if none does
  std::vector<ValueDifference> values;
  std::string advice;  // a sentence or two: where to look
};

/// Finds the first difference in the contacts that reach a body in a step (from 1), directly or through other bodies.
/// It goes through them in the order of a step: which bodies touch, where, and with what impulses. The states before
/// the step count as equal; `tolerance` is that of the step.
ContactCause find_contact_cause(const Scene&, const ComparedRun& a, const ComparedRun& b, std::size_t step,
                                std::size_t body, const StateTolerance& tolerance);

}  // namespace plumb
