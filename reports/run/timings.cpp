#include "reports/run/timings.h"

#include <fmt/format.h>

#include <exception>
#include <stdexcept>

#include "reports/timing/clock.h"
#include "reports/timing/repetitions.h"

namespace plumb {
namespace {

// 9 repetitions, which scenes so short that a single interrupt would show need; fewer, but at least 5, once they have
// taken 0.01 s, or at least 3, once they have taken 0.02 s.
constexpr RepetitionRule report_repetitions{.fewest = 5, .most = 9, .budget = 0.01, .slow = 0.02, .long_enough = 0.2};

double time_of_scene(const Scene& scene, const EngineConfig& config, double dt, double at_least) {
  try {
    return time_of_run([&] { return config.engine->build(scene, config.settings); }, dt, steps_in(scene.duration, dt),
                       at_least);
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format(
        "{} ran {}, but failed when it ran again to be timed: {}. A new simulation must not depend on earlier ones",
        config.engine->name, scene.name, error.what()));
  }
}

}  // namespace

std::vector<Timing> time_configs(const Case& timed, std::span<const EngineConfig> configs, double dt) {
  const Scene& scene = *timed.scene;
  std::vector<Repetitions> all(configs.size(), Repetitions(report_repetitions));
  repeat_until_settled(configs.size(), [&](std::size_t i) {
    if (all[i].settled()) return false;
    all[i].add(time_of_scene(scene, configs[i], dt, 0));
    return true;
  });

  const auto steps = static_cast<double>(steps_in(scene.duration, dt));
  std::vector<Timing> timings;
  for (std::size_t i = 0; i < configs.size(); ++i) {
    const Quartiles seconds = all[i].spread();
    const double us = 1e6 / steps;
    timings.push_back({.scenario = timed.scenario->name,
                       .variant = timed.variant,
                       .engine = configs[i].engine->name,
                       .method = configs[i].method(),
                       .step_us = seconds.median * us,
                       .step_us_low = seconds.low * us,
                       .step_us_high = seconds.high * us,
                       .real_time_factor = steps * dt / seconds.median,
                       .repetitions = static_cast<int>(all[i].counted().size())});
  }
  return timings;
}

double step_cost(const Scene& scene, const EngineConfig& config, double dt) {
  constexpr double least_time = 1.5e-3;  // s
  return time_of_scene(scene, config, dt, least_time) / (static_cast<double>(steps_in(scene.duration, dt)) * dt);
}

}  // namespace plumb
