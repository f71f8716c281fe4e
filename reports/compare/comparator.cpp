#include "reports/compare/comparator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "reports/judge/mechanics.h"
#include "reports/judge/scale.h"
#include "reports/judge/states.h"
#include "scenarios/scene/vec.h"

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

// The row that answers the first questions about two runs that reached their end, from the runs and from what
// `compare` found: their differences in pose at the moments of a, and the summaries of their other differences over
// time.
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

// A difference over time, summarised.
class DifferenceSummary {
 public:
  void add(double difference) {
    last_ = std::abs(difference);
    largest_ = std::max(largest_, last_);
    squares_ += last_ * last_;
    ++count_;
  }
  void put(std::map<std::string, Measured>& into, const std::string& name, const char* unit) const {
    into[name + "_max"] = {largest_, unit};
    into[name + "_rms"] = {std::sqrt(squares_ / count_), unit};
    into[name + "_end"] = {last_, unit};
  }

 private:
  double largest_ = 0, squares_ = 0, last_ = 0, count_ = 0;
};

void compare_poses(std::span<const PoseDifference> differences, Comparison& comparison) {
  DifferenceSummary position;
  DifferenceSummary angle;
  for (const PoseDifference& one : differences) {
    position.add(one.position);
    angle.add(one.angle);
  }
  position.put(comparison.metrics, "position_difference", "m");
  angle.put(comparison.metrics, "angle_difference", "rad");
}

void compare_conserved(const RunRecord& a, const RunRecord& b, Comparison& comparison) {
  const Conserved conserved(*a.scene);
  DifferenceSummary energy;
  DifferenceSummary momentum;
  DifferenceSummary angular;
  DifferenceSummary resting;
  std::vector<BodyState> of_run_b(a.trace->bodies());
  const double end = b.trace->times().back() * (1 + 1e-12);
  for (std::size_t moment = 0; moment < a.trace->size() && a.trace->time(moment) <= end; ++moment) {
    const auto of_run_a = a.trace->states(moment);
    for (std::size_t i = 0; i < of_run_b.size(); ++i) of_run_b[i] = b.trace->state_at(i, a.trace->time(moment));
    energy.add(conserved.energy(of_run_a).total() - conserved.energy(of_run_b).total());
    const Momentum of_a = conserved.momentum(of_run_a);
    const Momentum of_b = conserved.momentum(of_run_b);
    momentum.add(length(of_a.linear - of_b.linear));
    angular.add(of_a.angular - of_b.angular);
    resting.add(still_bodies(*a.scene, of_run_a) - still_bodies(*a.scene, of_run_b));
  }
  energy.put(comparison.metrics, "energy_difference", "J");
  momentum.put(comparison.metrics, "momentum_difference", "kg m/s");
  angular.put(comparison.metrics, "angular_momentum_difference", "kg m^2/s");
  resting.put(comparison.metrics, "resting_difference", "1");
}

void compare_rest(const RunRecord& a, const RunRecord& b, Comparison& comparison) {
  for (const char* name : {"residual_speed", "penetration_max", "penetration_end", "lateral_drift"}) {
    const auto of_a = a.metrics.find(name);
    const auto of_b = b.metrics.find(name);
    if (of_a == a.metrics.end() || of_b == b.metrics.end()) continue;
    comparison.metrics[std::string(name) + "_difference"] = {of_a->second.value - of_b->second.value,
                                                             of_a->second.unit};
  }
}

std::string label(const RunRecord& run) { return label_of(run.engine, run.method); }

// The verdict of the comparison is the worse of the two, with a reason that names its run.
void conclude(const RunRecord& a, const RunRecord& b, Comparison& comparison) {
  for (const Verdict worst : {Verdict::failed, Verdict::not_supported, Verdict::wrong, Verdict::beyond_horizon,
                              Verdict::no_evidence, Verdict::coarse}) {
    for (const RunRecord* run : {&a, &b}) {
      if (run->verdict != worst) continue;
      comparison.verdict = worst;
      comparison.reason = label(*run) + ": " + (run->reason.empty() ? name_of(worst) : run->reason);
      return;
    }
  }
  const bool both = a.verdict == Verdict::right && b.verdict == Verdict::right;
  comparison.verdict = both ? Verdict::right : Verdict::plausible;
}

bool ran(const RunRecord& run) { return run.status == Status::ok; }

Comparison compare_two(const RunRecord& a, const RunRecord& b, const Scales* scales) {
  Comparison comparison{.scenario = a.scenario, .variant = a.variant, .a = label(a), .b = label(b)};
  conclude(a, b, comparison);
  if (scales != nullptr && ran(a) && ran(b)) {
    const auto poses = pose_differences(*a.scene, *a.trace, *b.trace, std::numeric_limits<double>::infinity());
    compare_poses(poses, comparison);
    compare_conserved(a, b, comparison);
    compare_rest(a, b, comparison);
    comparison.key = key_differences(a, b, poses, comparison.metrics, *scales);
  }
  return comparison;
}

}  // namespace

std::vector<Comparison> compare(std::span<const RunRecord> runs, const Truth* truth) {
  std::vector<Comparison> comparisons;
  std::optional<Scales> scales;
  if (const auto one = std::find_if(runs.begin(), runs.end(), ran); one != runs.end())
    scales.emplace(*one->scene, truth);
  const auto add = [&](const RunRecord& a, const RunRecord& b) {
    comparisons.push_back(compare_two(a, b, scales ? &*scales : nullptr));
  };
  const RunRecord* exact = nullptr;
  std::vector<const RunRecord*> engines;
  for (const RunRecord& run : runs) {
    if (!run.exact) {
      engines.push_back(&run);
    } else if (ran(run)) {
      exact = &run;
    }
  }
  for (const RunRecord* engine : engines) {
    if (exact != nullptr) add(*engine, *exact);
  }
  for (std::size_t i = 0; i < engines.size(); ++i) {
    for (std::size_t j = i + 1; j < engines.size(); ++j) add(*engines[i], *engines[j]);
  }
  return comparisons;
}

}  // namespace plumb
