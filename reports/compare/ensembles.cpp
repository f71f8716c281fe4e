#include "reports/compare/ensembles.h"

#include <fmt/format.h>

#include <cmath>

#include "reports/judge/mechanics.h"
#include "reports/judge/metric.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/vec.h"

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

double rest_time_of(const Scene& scene, const Trace& trace) {
  const auto rest = Catalog<Metric>::find("time_to_rest")->measure({.scene = scene, .trace = trace});
  return rest.value_or(trace.times().back());
}

std::string ensemble_words(const EnsembleDifference& difference, int members) {
  return fmt::format("{} {:.3g} against {:.3g} {} (medians of {} runs; p = {:.1g}, effect {:.2f})", difference.quantity,
                     difference.a.median, difference.b.median, difference.unit, members, difference.p,
                     difference.effect);
}

void put_quartiles(Comparison& comparison, const std::string& name, const Quartiles& of, const std::string& unit) {
  comparison.metrics[name + "_low"] = {of.low, unit};
  comparison.metrics[name + "_median"] = {of.median, unit};
  comparison.metrics[name + "_high"] = {of.high, unit};
}

}  // namespace

std::vector<EnsembleSample> empty_samples() { return {{"energy", "J", {}}, {"spread", "m", {}}, {"rest", "s", {}}}; }

void add_run(std::vector<EnsembleSample>& samples, const Scene& scene, const Trace& trace) {
  const auto states = trace.states(trace.size() - 1);
  samples[0].values.push_back(Conserved(scene).energy(states).total());
  samples[1].values.push_back(spread_of(scene, states));
  samples[2].values.push_back(rest_time_of(scene, trace));
}

std::vector<EnsembleDifference> compare_ensembles(std::span<const EnsembleSample> a,
                                                  std::span<const EnsembleSample> b) {
  std::vector<EnsembleDifference> differences;
  std::vector<double> p;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].values.empty() || b[i].values.empty()) continue;
    const RankTest test = rank_test(a[i].values, b[i].values);
    differences.push_back(
        {a[i].quantity, a[i].unit, quartiles(a[i].values), quartiles(b[i].values), test.p, test.effect});
    p.push_back(test.p);
  }
  const std::vector<bool> different = significant(p, false_positive_rate);
  for (std::size_t i = 0; i < differences.size(); ++i) differences[i].different = different[i];
  return differences;
}

std::string differences_in_words(std::span<const EnsembleDifference> differences, int members) {
  std::string words;
  for (const EnsembleDifference& one : differences) {
    if (one.different) words += (words.empty() ? "different: " : "; ") + ensemble_words(one, members);
  }
  return words;
}

void add_ensembles(Comparison& comparison, std::span<const EnsembleDifference> differences, double horizon,
                   int members) {
  comparison.metrics["horizon"] = {horizon, "s"};
  for (const EnsembleDifference& one : differences) {
    const std::string name = "ensemble_" + one.quantity;
    put_quartiles(comparison, name + "_a", one.a, one.unit);
    put_quartiles(comparison, name + "_b", one.b, one.unit);
    comparison.metrics[name + "_p"] = {one.p, "1"};
    comparison.metrics[name + "_effect"] = {one.effect, "1"};
  }
  const std::string different = differences_in_words(differences, members);
  if (comparison.verdict == Verdict::wrong || comparison.verdict == Verdict::failed ||
      comparison.verdict == Verdict::not_supported) {
    return;
  }
  comparison.verdict = different.empty() ? Verdict::beyond_horizon : Verdict::plausible;
  comparison.reason = different.empty()
                          ? fmt::format(
                                "plausible beyond the horizon at {:.3g} s: {} runs of each from perturbed starts "
                                "differ neither in energy nor in spread nor in rest time",
                                horizon, members)
                          : different;
}

}  // namespace plumb
