#include "reports/run/more_iterations.h"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

bool differ_in_iterations_alone(const Stepping& a, const Stepping& b) {
  return (a.iterations != b.iterations || a.position_iterations != b.position_iterations) && a.dt == b.dt && a.h == b.h;
}

std::string joined(const std::string& counts, const std::string& count) {
  return counts.empty() ? count : counts + "/" + count;
}

}  // namespace

std::optional<MoreIterations> with_more_iterations(const EngineConfig& config, double dt) {
  const Stepping stated = config.engine->stepping(config.settings, dt);
  MoreIterations more{.config = config};
  std::string why_not;
  for (const Option& option : config.engine->options) {
    const auto given = config.settings.find(option.key);
    if (!option.whole || given == config.settings.end()) continue;
    const double count = std::stod(given->second);
    const double most = std::min(more_times * count, option.max);
    if (!(most > count)) continue;
    const std::string after = std::to_string(std::llround(most));
    Settings changed = config.settings;
    changed[option.key] = after;
    const auto with_changed = stepping_of({config.engine, changed}, dt, why_not);
    if (!with_changed || !differ_in_iterations_alone(stated, *with_changed)) continue;
    more.before = joined(more.before, given->second);
    more.after = joined(more.after, after);
    more.config.settings[option.key] = after;
  }
  if (more.before.empty()) return std::nullopt;
  return more;
}

}  // namespace plumb
