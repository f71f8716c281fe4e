#include "reports/run/ensemble.h"

#include <cmath>

#include "reports/judge/conserved.h"
#include "reports/judge/metric.h"
#include "reports/rank_test.h"
#include "reports/vec.h"
#include "scenarios/transformed.h"

namespace plumb {
namespace {

// m, RMS distance of the dynamic bodies from their centroid.
double spread_of(const Scene& scene, std::span<const BodyState> states) {
  Vec sum;
  double count = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (scene.bodies[i].type != BodyType::dynamic) continue;
    sum = sum + states[i].position;
    ++count;
  }
  if (count == 0) return 0;
  const Vec centroid = (1 / count) * sum;
  double squares = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (scene.bodies[i].type != BodyType::dynamic) continue;
    const Vec off = states[i].position - centroid;
    squares += dot(off, off);
  }
  return std::sqrt(squares / count);
}

double rest_of(const Scene& scene, const Trace& trace) {
  const auto rest = Catalog<Metric>::find("time_to_rest")->measure({.scene = scene, .trace = trace});
  return rest.value_or(trace.times().back());
}

}  // namespace

std::vector<Sample> ensemble_of(const Scene& scene, const EngineConfig& config, double dt, double size, int members,
                                std::uint64_t first_seed) {
  const Conserved conserved(scene);
  std::vector<Sample> samples{{"energy", "J", {}}, {"spread", "m", {}}, {"rest", "s", {}}};
  for (int member = 0; member < members; ++member) {
    const Outcome outcome = run(perturbed(scene, size, first_seed + static_cast<std::uint64_t>(member)), config, dt);
    if (outcome.status != Status::ok) continue;
    const auto states = outcome.trace->states(outcome.trace->size() - 1);
    samples[0].values.push_back(conserved.energy(states).total());
    samples[1].values.push_back(spread_of(scene, states));
    samples[2].values.push_back(rest_of(scene, *outcome.trace));
  }
  return samples;
}

std::vector<Contrast> contrast(std::span<const Sample> a, std::span<const Sample> b) {
  std::vector<Contrast> contrasts;
  std::vector<double> p;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].values.empty() || b[i].values.empty()) continue;
    const RankTest test = rank_test(a[i].values, b[i].values);
    contrasts.push_back(
        {a[i].quantity, a[i].unit, quartiles(a[i].values), quartiles(b[i].values), test.p, test.effect});
    p.push_back(test.p);
  }
  const std::vector<bool> stands = significant(p, false_alarm);
  for (std::size_t i = 0; i < contrasts.size(); ++i) contrasts[i].different = stands[i];
  return contrasts;
}

}  // namespace plumb
