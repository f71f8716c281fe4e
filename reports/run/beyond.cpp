#include "reports/run/beyond.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "reports/run/ensemble.h"
#include "reports/run/horizon.h"

namespace plumb {
namespace {

constexpr std::uint64_t first_seed = 1;

std::string label(const EngineConfig& config) { return label_of(config.engine->name, config.method()); }

std::optional<double> own_horizon(const Scene& scene, const EngineConfig& config, double dt) {
  const Outcome outcome = run(scene, config, dt);
  if (outcome.status != Status::ok) return std::nullopt;
  return horizon_of(scene, config, dt, *outcome.trace);
}

std::string in_words(const Contrast& contrast, int members) {
  return fmt::format("{} {:.3g} against {:.3g} {} (medians of {} runs; p = {:.1g}, effect {:.2f})", contrast.quantity,
                     contrast.a.median, contrast.b.median, contrast.unit, members, contrast.p, contrast.effect);
}

void put(Comparison& comparison, const std::string& name, const Quartiles& of, const std::string& unit) {
  comparison.metrics[name + "_low"] = {of.low, unit};
  comparison.metrics[name + "_median"] = {of.median, unit};
  comparison.metrics[name + "_high"] = {of.high, unit};
}

void conclude(Comparison& comparison, std::span<const Contrast> contrasts, double horizon, int members) {
  comparison.metrics["horizon"] = {horizon, "s"};
  std::string different;
  for (const Contrast& one : contrasts) {
    const std::string name = "ensemble_" + one.quantity;
    put(comparison, name + "_a", one.a, one.unit);
    put(comparison, name + "_b", one.b, one.unit);
    comparison.metrics[name + "_p"] = {one.p, "1"};
    comparison.metrics[name + "_effect"] = {one.effect, "1"};
    if (one.different) different += (different.empty() ? "different: " : "; ") + in_words(one, members);
  }
  if (comparison.verdict != Verdict::right && comparison.verdict != Verdict::plausible) return;
  comparison.verdict = different.empty() ? Verdict::beyond_horizon : Verdict::plausible;
  comparison.reason = different.empty()
                          ? fmt::format(
                                "plausible beyond the horizon at {:.3g} s: {} runs of each, from starts next to "
                                "each other, differ neither in energy nor in spread nor in rest",
                                horizon, members)
                          : different;
}

}  // namespace

std::optional<double> horizon_of(const Scene& scene, double dt) {
  const Engine& ours = *Catalog<Engine>::find("impulse");
  return own_horizon(scene, {&ours, complete(ours, {{"precision", "double"}})}, dt);
}

void look_beyond(const Case& asked, std::span<const EngineConfig> able, double dt, int members,
                 std::span<RunRecord> records, std::span<Comparison> comparisons) {
  const Scene& scene = *asked.scene;
  double size = 0;
  for (const EngineConfig& config : able) {
    size = std::max(size, smallest_difference(scene, config.engine->stepping(config.settings, dt)));
    for (RunRecord& record : records) {
      if (label_of(record.engine, record.method) != label(config)) continue;
      if (const auto own = horizon_of(scene, config, dt, *record.trace)) record.metrics["horizon"] = {*own, "s"};
    }
  }
  const auto horizon = horizon_of(scene, dt);
  if (!horizon || comparisons.empty()) return;
  std::map<std::string, std::vector<Sample>> ensembles;
  for (const EngineConfig& config : able) {
    ensembles[label(config)] = ensemble_of(scene, config, dt, size, members, first_seed);
  }
  for (Comparison& comparison : comparisons) {
    const auto a = ensembles.find(comparison.a);
    const auto b = ensembles.find(comparison.b);
    if (a == ensembles.end() || b == ensembles.end()) continue;
    conclude(comparison, contrast(a->second, b->second), *horizon, members);
  }
}

MetricNote horizon_note() {
  return {.name = "horizon",
          .unit = "s",
          .definition =
              "from when on runs of this engine, started up to 1e-9 m away (or 8 units of round-off of where a "
              "body is, if that is more), are a tenth of the smallest body apart; nothing if not by the end",
          .better = "neither"};
}

}  // namespace plumb
