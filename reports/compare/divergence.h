#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reports/compare/contact_cause.h"

/// When and why two runs of one scene diverge.
namespace plumb {

/// A moment at which the difference has grown by a factor since the divergence.
struct DivergenceGrowth {
  double factor = 1;
  std::size_t step = 0;
  double time = 0;        // s
  double difference = 0;  // the largest of all bodies, in the unit of the first difference
};

struct Divergence {
  std::size_t step = 0;  // 0 is the start
  double time = 0;       // s
  Stage stage = Stage::integration;
  std::string body;                      // with the largest error ratio
  std::string other;                     // the body at the contact that explains it; "" if none does
  ValueDifference first;                 // of the body's state
  std::vector<ValueDifference> values;   // the body's state and the contact that explains the divergence
  std::string advice;                    // a sentence or two: where to look
  std::vector<DivergenceGrowth> growth;  // at 1, 10, 100 ... times as far as it went, and at the end
};

struct TraceComparison {
  std::size_t steps = 0;    // that both have
  double until = 0;         // s
  ValueDifference largest;  // without divergence: the difference with the largest error ratio
  std::optional<Divergence> divergence;
};

/// Finds the first step after which any body's state differs by more than `tolerance` (the same number in m, rad, m/s
/// and rad/s) or, without one, by more than round-off explains. If one run ends early, so does the comparison. Throws
/// std::invalid_argument unless both runs are of that scene with the same time step.
TraceComparison compare_traces(const Scene&, const ComparedRun& a, const ComparedRun& b,
                               std::optional<double> tolerance);

}  // namespace plumb
