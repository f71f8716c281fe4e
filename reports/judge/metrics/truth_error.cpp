#include <algorithm>
#include <cmath>

#include "reports/judge/metric.h"
#include "reports/judge/states.h"
#include "scenarios/catalog.h"

namespace plumb::metrics::truth_error {
namespace {

using Differences = std::vector<PoseDifference>;

template <class Reduce>
Metric error(const char* name, const char* unit, const char* definition, Reduce reduce) {
  return {.name = name,
          .unit = unit,
          .definition = definition,
          .measure = [reduce](const MetricContext& context) -> std::optional<double> {
            if (context.truth == nullptr) return std::nullopt;
            const Differences all = pose_differences(context.scene, context.trace, *context.truth, context.truth_until);
            if (all.empty()) return std::nullopt;
            return reduce(all);
          }};
}

double largest(const Differences& all) {
  double most = 0;
  for (const PoseDifference& one : all) most = std::max(most, one.position);
  return most;
}

double largest_angle(const Differences& all) {
  double most = 0;
  for (const PoseDifference& one : all) most = std::max(most, one.angle);
  return most;
}

double rms(const Differences& all) {
  double squares = 0;
  for (const PoseDifference& one : all) squares += one.position * one.position;
  return std::sqrt(squares / static_cast<double>(all.size()));
}

double last(const Differences& all) { return all.back().position; }

const Catalog<Metric>::Entry max_entry{
    error("truth_error_max", "m", "largest RMS distance of the bodies from the closed form", largest)};
const Catalog<Metric>::Entry rms_entry{
    error("truth_error_rms", "m", "RMS over time and bodies of the distance from the closed form", rms)};
const Catalog<Metric>::Entry end_entry{
    error("truth_error_end", "m",
          "RMS distance of the bodies from the closed form at the end of the run, or when the closed form ends", last)};
const Catalog<Metric>::Entry angle_entry{error("truth_angle_error_max", "rad",
                                               "largest RMS difference of the bodies' angles from the closed form",
                                               largest_angle)};

}  // namespace
}  // namespace plumb::metrics::truth_error
