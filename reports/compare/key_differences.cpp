#include "reports/compare/key_differences.h"

#include <algorithm>

namespace plumb {
namespace {

RelativeDifference relative(const std::map<std::string, Measured>& metrics, const std::string& name, double scale) {
  return {error_ratio(metrics.at(name + "_max").value, scale), error_ratio(metrics.at(name + "_end").value, scale)};
}

std::optional<double> overlap_in(const RunRecord& run) {
  const auto found = run.metrics.find("penetration_max");
  return found == run.metrics.end() ? std::nullopt : std::optional(found->second.value);
}

std::optional<double> divergence(const Trace& trace, std::span<const PoseDifference> poses) {
  const auto first =
      std::find_if(poses.begin(), poses.end(), [](const auto& one) { return one.position > diverged_by; });
  if (first == poses.end()) return std::nullopt;
  return trace.time(static_cast<std::size_t>(first - poses.begin()));
}

}  // namespace

KeyDifferences key_differences(const RunRecord& a, const RunRecord& b, std::span<const PoseDifference> poses,
                               const std::map<std::string, Measured>& differences, const Scales& scales) {
  return {.energy = relative(differences, "energy_difference", scales.energy()),
          .momentum = relative(differences, "momentum_difference", scales.momentum()),
          .angular_momentum = relative(differences, "angular_momentum_difference", scales.angular_momentum()),
          .energy_scale = scales.energy(),
          .momentum_scale = scales.momentum(),
          .angular_momentum_scale = scales.angular_momentum(),
          .rest_a = time_to_rest(*a.scene, *a.trace),
          .rest_b = time_to_rest(*b.scene, *b.trace),
          .overlap_a = overlap_in(a),
          .overlap_b = overlap_in(b),
          .diverged_at = divergence(*a.trace, poses)};
}

}  // namespace plumb
