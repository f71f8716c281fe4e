#include "reports/compare/comparator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/judge/conserved.h"
#include "reports/judge/pose_difference.h"
#include "reports/judge/still.h"
#include "reports/vec.h"

namespace plumb {
namespace {

// Two runs have parted when their bodies are a centimetre apart: a hundredth of bodies the size of a metre.
constexpr double diverged_by = 0.01;  // m

// One difference over time, boiled down.
class Series {
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

void compare_poses(const RunRecord& a, const RunRecord& b, Comparison& comparison) {
  const auto apart = pose_differences(*a.scene, *a.trace, *b.trace, std::numeric_limits<double>::infinity());
  Series position;
  Series angle;
  for (const PoseDifference& one : apart) {
    position.add(one.position);
    angle.add(one.angle);
  }
  position.put(comparison.metrics, "position_difference", "m");
  angle.put(comparison.metrics, "angle_difference", "rad");
  const auto first =
      std::find_if(apart.begin(), apart.end(), [](const auto& one) { return one.position > diverged_by; });
  if (first != apart.end()) {
    comparison.metrics["parted_at"] = {a.trace->time(static_cast<std::size_t>(first - apart.begin())), "s"};
  }
}

void compare_conserved(const RunRecord& a, const RunRecord& b, Comparison& comparison) {
  const Conserved conserved(*a.scene);
  Series energy;
  Series momentum;
  Series angular;
  Series resting;
  std::vector<BodyState> there(a.trace->bodies());
  const double end = b.trace->times().back() * (1 + 1e-12);
  for (std::size_t moment = 0; moment < a.trace->size() && a.trace->time(moment) <= end; ++moment) {
    const auto here = a.trace->states(moment);
    for (std::size_t i = 0; i < there.size(); ++i) there[i] = b.trace->state_at(i, a.trace->time(moment));
    energy.add(conserved.energy(here).total() - conserved.energy(there).total());
    const Momentum of_a = conserved.momentum(here);
    const Momentum of_b = conserved.momentum(there);
    momentum.add(length(of_a.linear - of_b.linear));
    angular.add(of_a.angular - of_b.angular);
    resting.add(still_bodies(*a.scene, here) - still_bodies(*a.scene, there));
  }
  energy.put(comparison.metrics, "energy_difference", "J");
  momentum.put(comparison.metrics, "momentum_difference", "kg m/s");
  angular.put(comparison.metrics, "angular_momentum_difference", "kg m^2/s");
  resting.put(comparison.metrics, "resting_difference", "1");
}

void compare_rest(const RunRecord& a, const RunRecord& b, Comparison& comparison) {
  for (const char* name : {"time_to_rest", "residual_speed", "penetration_max", "penetration_end", "lateral_drift"}) {
    const auto of_a = a.metrics.find(name);
    const auto of_b = b.metrics.find(name);
    if (of_a == a.metrics.end() || of_b == b.metrics.end()) continue;
    comparison.metrics[std::string(name) + "_difference"] = {of_a->second.value - of_b->second.value,
                                                             of_a->second.unit};
  }
}

std::string label(const RunRecord& run) { return label_of(run.engine, run.method); }

// The worse of two verdicts is that of the comparison, and tells whose it is.
void conclude(const RunRecord& a, const RunRecord& b, Comparison& comparison) {
  for (const Verdict worst : {Verdict::failed, Verdict::not_supported, Verdict::wrong, Verdict::beyond_horizon}) {
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

Comparison compare(const RunRecord& a, const RunRecord& b) {
  Comparison comparison{.scenario = a.scenario, .variant = a.variant, .a = label(a), .b = label(b)};
  conclude(a, b, comparison);
  if (a.status == Status::ok && b.status == Status::ok) {
    compare_poses(a, b, comparison);
    compare_conserved(a, b, comparison);
    compare_rest(a, b, comparison);
  }
  return comparison;
}

}  // namespace

std::vector<Comparison> compare(std::span<const RunRecord> runs) {
  std::vector<Comparison> comparisons;
  const RunRecord* truth = nullptr;
  std::vector<const RunRecord*> engines;
  for (const RunRecord& run : runs) {
    if (!run.exact) {
      engines.push_back(&run);
    } else if (run.status == Status::ok) {
      truth = &run;
    }
  }
  for (const RunRecord* engine : engines) {
    if (truth != nullptr) comparisons.push_back(compare(*engine, *truth));
  }
  for (std::size_t i = 0; i < engines.size(); ++i) {
    for (std::size_t j = i + 1; j < engines.size(); ++j) comparisons.push_back(compare(*engines[i], *engines[j]));
  }
  return comparisons;
}

}  // namespace plumb
