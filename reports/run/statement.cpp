#include "reports/run/statement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumb {
namespace {

bool differ_in_iterations_alone(const Stepping& a, const Stepping& b) {
  return (a.iterations != b.iterations || a.position_iterations != b.position_iterations) && a.dt == b.dt && a.h == b.h;
}

std::string joined(const std::string& counts, const std::string& count) {
  return counts.empty() ? count : counts + "/" + count;
}

}  // namespace

std::string statement(const Stepping& stepping) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  constexpr double mm = 1000;
  if (stepping.order > 0)
    add(fmt::format("order {} in free motion, in sub-steps of {:.3g} ms", stepping.order, stepping.h * mm));
  if (stepping.impact_lag > 0)
    add(fmt::format("finds impacts up to {:.3g} ms late", stepping.impact_lag * stepping.h * mm));
  if (stepping.impact_lead > 0)
    add(fmt::format("brakes an approach up to {:.3g} ms early", stepping.impact_lead * stepping.h * mm));
  if (stepping.skin > 0) add(fmt::format("bodies may rest {:.3g} mm apart", stepping.skin * mm));
  if (stepping.slop > 0) add(fmt::format("leaves overlaps of up to {:.3g} mm alone", stepping.slop * mm));
  if (stepping.contact_frequency > 0) {
    add(fmt::format("contacts are springs of {:.3g} Hz, {:.3g} Hz on what does not move, and overlap by their load",
                    stepping.contact_frequency, stepping.fixed_contact_frequency));
  }
  if (stepping.held_anchors) add("holds contact points on both bodies for a step, which lets rolling bodies sink in");
  if (stepping.tangent_rotation) add("turns by atan(w h) in a sub-step");
  if (stepping.joint_frequency > 0) {
    add(fmt::format("joints are springs of {:.3g} Hz and open by their load", stepping.joint_frequency));
  }
  if (stepping.joint_slop > 0) add(fmt::format("joints may be open by {:.3g} mm", stepping.joint_slop * mm));
  if (stepping.angular_slop > 0) {
    add(fmt::format("a hinge may rest {:.3g} degrees past its limit", stepping.angular_slop * 180 / std::numbers::pi));
  }
  if (stepping.creep > 0) add(fmt::format("what sticks may creep at {:.3g} mm/s", stepping.creep * mm));
  if (stepping.rest_speed > 0) add(fmt::format("puts to sleep below {:.3g} m/s", stepping.rest_speed));
  if (stepping.restitution_threshold > 0)
    add(fmt::format("nothing bounces below {:.3g} m/s", stepping.restitution_threshold));
  if (stepping.position_iterations > 0) {
    add(fmt::format("{} iterations of velocities, {} of positions", stepping.iterations, stepping.position_iterations));
  } else if (stepping.iterations > 0) {
    add(fmt::format("{} iteration{}", stepping.iterations, stepping.iterations == 1 ? "" : "s"));
  }
  if (stepping.epsilon > 0) add(stepping.epsilon > 1e-9 ? "single precision" : "double precision");
  if (stepping.differenced_velocities) add("keeps velocities as differences of positions");
  return text;
}

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
