#include "reports/run/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <exception>
#include <stdexcept>

#include "reports/timing/clock.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

// A NaN that no arithmetic produces: a value that still has it was not written.
constexpr std::uint64_t blank_bits = 0x7ff8'706c'756d'6221;
const double blank = std::bit_cast<double>(blank_bits);
const BodyState unwritten{{blank, blank}, blank, {blank, blank}, blank};

bool is_blank(double value) { return std::bit_cast<std::uint64_t>(value) == blank_bits; }

bool any_blank(const BodyState& state) {
  return is_blank(state.position.x) || is_blank(state.position.y) || is_blank(state.angle) ||
         is_blank(state.velocity.x) || is_blank(state.velocity.y) || is_blank(state.angular_velocity);
}

bool finite(Vec v) { return std::isfinite(v.x) && std::isfinite(v.y); }

std::string error_in(const ContactState& contact, std::size_t bodies) {
  if (contact.a >= bodies || contact.b >= bodies || contact.a == contact.b) {
    return fmt::format("is between bodies {} and {} of a scene of {}, counted from 0", contact.a, contact.b, bodies);
  }
  const bool all_finite = finite(contact.point) && finite(contact.normal) && std::isfinite(contact.normal_impulse) &&
                          std::isfinite(contact.tangent_impulse) && std::isfinite(contact.separation);
  return all_finite ? "" : "has numbers that are not finite";
}

}  // namespace

std::span<const BodyState> Readout::states(const Simulation& simulation) {
  const std::size_t bodies = scene_.bodies.size();
  constexpr std::size_t guard = 16;  // states past the end, where a write does no harm and is noticed
  states_.assign(bodies + guard, unwritten);
  const std::span<BodyState> result = std::span(states_).first(bodies);
  simulation.read(result);
  for (std::size_t i = 0; i < bodies; ++i) {
    if (!any_blank(result[i])) continue;
    throw std::runtime_error(fmt::format("read() left out body \"{}\": it must write the whole state of all {} bodies",
                                         scene_.bodies[i].name, bodies));
  }
  for (const BodyState& state : std::span(states_).subspan(bodies)) {
    if (any_blank(state)) continue;
    throw std::runtime_error(
        fmt::format("read() wrote past the end: the scene has {} bodies, in the order of Scene::bodies", bodies));
  }
  return result;
}

std::span<const ContactState> Readout::contacts(const Simulation& simulation) {
  contacts_.clear();
  simulation.read_contacts(contacts_);
  for (const ContactState& contact : contacts_) {
    const std::string error = error_in(contact, scene_.bodies.size());
    if (!error.empty()) throw std::runtime_error("read_contacts(): a contact " + error);
  }
  return contacts_;
}

namespace {

constexpr const char* threw_no_exception = "it threw something that is not a std::exception";

// A scene in SI units that plays for minutes under Earth's gravity reaches 1e3 m/s and 1e5 m. Beyond a hundred times
// that, an engine has blown up, even if its numbers are still finite.
constexpr double largest_sane_speed = 1e6;     // m/s, and rad/s
constexpr double largest_sane_distance = 1e7;  // m

// Comparisons with NaN are false, so what is not finite is not sane.
bool sane(const BodyState& state) {
  return std::abs(state.position.x) <= largest_sane_distance && std::abs(state.position.y) <= largest_sane_distance &&
         std::abs(state.velocity.x) <= largest_sane_speed && std::abs(state.velocity.y) <= largest_sane_speed &&
         std::abs(state.angular_velocity) <= largest_sane_speed && std::isfinite(state.angle);
}

std::string divergence_message(const Body& body, const BodyState& lost, double time) {
  return fmt::format(
      "diverged at t = {:.4g} s: body \"{}\" at ({:.3g}, {:.3g}) m, {:.3g} rad, {:.3g} m/s, {:.3g} rad/s", time,
      body.name, lost.position.x, lost.position.y, lost.angle, length(lost.velocity), lost.angular_velocity);
}

void step_to_end(const Scene& scene, Simulation& simulation, double dt, double first_step, Readout& readout,
                 const Observer& observer, Outcome& outcome) {
  if (!observer(0, readout.states(simulation))) return;

  const double valid = simulation.valid_until();
  const double missing = 1 - first_step;
  const bool cut = missing > 0;
  const std::size_t steps = steps_in(scene.duration + missing * dt, dt);
  for (std::size_t i = 1; i <= steps; ++i) {
    // Not a sum of steps, which would accumulate the rounding of each.
    const double whole = (static_cast<double>(i) - missing) * dt;
    const double time = cut && i == steps ? scene.duration : whole;
    if (time > valid) return;
    const double step = cut && (i == 1 || i == steps) ? time - outcome.time : dt;
    outcome.time = time;
    if (i == (cut ? 2U : 1U)) simulation.announce(dt, steps - (cut ? 2 : 0));
    const Stopwatch in_step;
    simulation.step(step);
    outcome.stepping += in_step.seconds();
    if (const auto own = simulation.seconds_stepped()) outcome.stepping = *own;

    const std::span<const BodyState> states = readout.states(simulation);
    const auto lost = std::find_if_not(states.begin(), states.end(), sane);
    if (lost != states.end()) {
      outcome.status = Status::failed;
      outcome.lost = static_cast<std::size_t>(lost - states.begin());
      outcome.reason = divergence_message(scene.bodies[*outcome.lost], *lost, time);
      return;
    }
    if (!observer(time, states)) return;
  }
}

// `make_observer` makes the observer once the simulation is built.
template <class MakeObserver>
Outcome run_observed(const Scene& scene, const EngineConfig& config, double dt, double first_step,
                     MakeObserver make_observer) {
  const Stopwatch all;
  Outcome outcome;
  try {
    outcome.reason = config.engine->unsupported(scene, config.settings);
    if (!outcome.reason.empty()) {
      outcome.status = Status::not_supported;
      return outcome;
    }
    config.engine->stepping(config.settings, dt);  // an engine that fails to say it fails its run
    const auto simulation = config.engine->build(scene, config.settings);
    Readout readout(scene);
    step_to_end(scene, *simulation, dt, first_step, readout, make_observer(outcome, *simulation, readout), outcome);
  } catch (const std::domain_error& error) {
    // Some methods only find out during the run that they cannot handle a scene.
    outcome.status = Status::not_supported;
    outcome.reason = error.what();
    outcome.trace = nullptr;
  } catch (const std::exception& error) {
    outcome.status = Status::failed;
    outcome.reason = error.what();
  } catch (...) {
    outcome.status = Status::failed;
    outcome.reason = threw_no_exception;
  }
  outcome.wall = all.seconds();
  return outcome;
}

}  // namespace

std::string EngineConfig::method() const {
  std::string text;
  for (const Option& option : engine->options) {
    const std::string& value = settings.at(option.key);
    if (value != option.value) text += (text.empty() ? "" : ",") + option.key + "=" + value;
  }
  return text;
}

std::optional<Stepping> stepping_of(const EngineConfig& config, double dt, std::string& why_not) {
  try {
    return config.engine->stepping(config.settings, dt);
  } catch (const std::exception& error) {
    why_not = error.what();
  } catch (...) {
    why_not = threw_no_exception;
  }
  return std::nullopt;
}

std::size_t steps_in(double duration, double dt) {
  // 2 s at 1/60 s are 120 steps, although 2 / (1/60.) may round up.
  return static_cast<std::size_t>(std::max(0.0, std::ceil(duration / dt * (1 - 1e-12))));
}

Outcome run(const Scene& scene, const EngineConfig& config, double dt, double first_step) {
  return run_observed(
      scene, config, dt, first_step, [&](Outcome& outcome, const Simulation& simulation, Readout& readout) -> Observer {
        outcome.trace = std::make_shared<Trace>(scene.bodies.size());
        outcome.trace->reserve(steps_in(scene.duration, dt) + 1);
        return [&](double time, std::span<const BodyState> states) {
          const bool start = outcome.trace->size() == 0;
          outcome.trace->record(time, states, start ? std::span<const ContactState>{} : readout.contacts(simulation));
          return true;
        };
      });
}

Outcome watch(const Scene& scene, const EngineConfig& config, double dt, double first_step, const Observer& observer) {
  return run_observed(scene, config, dt, first_step,
                      [&](Outcome&, const Simulation&, Readout&) -> const Observer& { return observer; });
}

}  // namespace plumb
