#include "reports/judge/observe.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenarios/scene/nearest.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

// Through (-1, a), (0, b), (1, c): y(s) = b + (c-a) s/2 + (a-2b+c) s^2/2, with its vertex at s = (a-c)/(2 (a-2b+c)).
Observation vertex(double time, double step, double a, double b, double c) {
  const double bend = a - 2 * b + c;
  const double s = (a - c) / (2 * bend);
  return {time + s * step, b - (c - a) * (c - a) / (8 * bend)};
}

std::optional<Observation> apex(const Trace& trace, std::size_t body, int index) {
  const auto y = [&](std::size_t moment) { return trace.states(moment)[body].position.y; };
  int count = 0;
  for (std::size_t i = 1; i + 1 < trace.size(); ++i) {
    const bool highest = y(i - 1) < y(i) && y(i) >= y(i + 1);
    if (highest && ++count == index) {
      return vertex(trace.time(i), trace.time(i) - trace.time(i - 1), y(i - 1), y(i), y(i + 1));
    }
  }
  return std::nullopt;
}

// s after the first of two states, T apart, at which the flight from the one meets the flight back from the other, both
// with the acceleration a: y1 + v1 s + a s^2/2 = y2 - v2 (T - s) + a (T - s)^2/2, in which s^2 cancels.
double crossing(const BodyState& from, const BodyState& to, double a, double T) {
  const double closing = from.velocity.y - to.velocity.y + a * T;
  const double apart = to.position.y - from.position.y - to.velocity.y * T + a * T * T / 2;
  return std::clamp(apart / closing, 0.0, T);
}

std::optional<Observation> landing(const Scene& scene, const Trace& trace, std::size_t body, int index) {
  const auto y = [&](std::size_t moment) { return trace.states(moment)[body].position.y; };
  const double a = scene.gravity.y * scene.bodies[body].gravity_scale;
  int count = 0;
  for (std::size_t i = 1; i + 1 < trace.size(); ++i) {
    const bool lowest = y(i - 1) > y(i) && y(i) <= y(i + 1);
    if (!lowest || ++count != index) continue;
    const BodyState& before = trace.states(i - 1)[body];
    const BodyState& after = trace.states(i + 1)[body];
    const double turned = before.velocity.y - after.velocity.y;
    if (turned >= 0) return Observation{trace.time(i), trace.time(i)};
    const double time = trace.time(i - 1) + crossing(before, after, a, trace.time(i + 1) - trace.time(i - 1));
    return Observation{time, time};
  }
  return std::nullopt;
}

double speed_spread(const Conserved& conserved, std::span<const BodyState> states) {
  double squares = 0;
  double fourths = 0;
  double bodies = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (conserved.masses()[i].mass == 0) continue;
    const double square = dot(states[i].velocity, states[i].velocity);
    squares += square;
    fourths += square * square;
    ++bodies;
  }
  return bodies * fourths / (squares * squares);
}

// The quantity at which this one changes; nullopt unless it is a pose.
std::optional<Quantity> speed_behind(Quantity quantity) {
  switch (quantity) {
    case Quantity::x:
      return Quantity::vx;
    case Quantity::y:
      return Quantity::vy;
    case Quantity::angle:
      return Quantity::angular_velocity;
    default:
      return std::nullopt;
  }
}

// Between two moments T apart: the cubic through the places and speeds there, exact in free flight. The chord would be
// off by up to g T^2/8.
double between(double from, double to, double speed_from, double speed_to, double T, double fraction) {
  const double rest = 1 - fraction;
  const double chord = from + fraction * (to - from);
  return chord + fraction * rest * (rest * (speed_from * T - (to - from)) - fraction * (speed_to * T - (to - from)));
}

// N: the normal impulses of the step that ends at the moment, over its duration; between the two bodies, or on `body`
// from any other.
double load(const Trace& trace, std::size_t moment, std::size_t body, std::optional<std::size_t> other) {
  if (moment == 0) return 0;
  double impulse = 0;
  for (const ContactState& contact : trace.contacts(moment)) {
    const auto of = [&contact](std::size_t one) { return contact.a == one || contact.b == one; };
    if (of(body) && (!other || of(*other))) impulse += contact.normal_impulse;
  }
  return impulse / (trace.time(moment) - trace.time(moment - 1));
}

}  // namespace

Observation energy_rise(const Conserved& conserved, const Trace& trace, std::size_t last) {
  double lowest = conserved.energy(trace.states(0)).total();
  Observation most{trace.time(0), 0};
  for (std::size_t i = 1; i <= last; ++i) {
    const double energy = conserved.energy(trace.states(i)).total();
    if (energy - lowest > most.value) most = {trace.time(i), energy - lowest};
    lowest = std::min(lowest, energy);
  }
  return most;
}

bool is_reported(const Trace& trace, Quantity quantity) { return quantity != Quantity::load || trace.has_contacts(); }

std::size_t index_of(const Scene& scene, std::string_view name) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].name == name) return i;
    names.push_back(scene.bodies[i].name);
  }
  throw std::invalid_argument(scene.name + ": " + unknown("body", name, names));
}

double quantity_of(Quantity quantity, std::size_t body, const Conserved& conserved, std::span<const BodyState> states) {
  switch (quantity) {
    case Quantity::x:
      return states[body].position.x;
    case Quantity::y:
      return states[body].position.y;
    case Quantity::angle:
      return states[body].angle;
    case Quantity::vx:
      return states[body].velocity.x;
    case Quantity::vy:
      return states[body].velocity.y;
    case Quantity::speed:
      return length(states[body].velocity);
    case Quantity::angular_velocity:
      return states[body].angular_velocity;
    case Quantity::energy:
      return conserved.energy(states).total();
    case Quantity::momentum_x:
      return conserved.momentum(states).linear.x;
    case Quantity::momentum_y:
      return conserved.momentum(states).linear.y;
    case Quantity::angular_momentum:
      return conserved.momentum(states).angular;
    case Quantity::speed_spread:
      return speed_spread(conserved, states);
    case Quantity::load:
    case Quantity::energy_rise:
    case Quantity::landing:
    case Quantity::apex:
      break;
  }
  throw std::invalid_argument(std::string(name_of(quantity)) + " is a quantity of a trace, not of a moment");
}

std::optional<Observation> observe(const Scene& scene, const Trace& trace, const Expectation& expectation,
                                   double time) {
  const std::size_t body = expectation.body.empty() ? 0 : index_of(scene, expectation.body);
  if (expectation.quantity == Quantity::apex) return apex(trace, body, expectation.index);
  if (expectation.quantity == Quantity::landing) return landing(scene, trace, body, expectation.index);
  const double when = expectation.time.value_or(time);
  // The last step ends at the end of the scene, except for the rounding of steps times dt.
  const double rounding = 1e-9 * std::abs(when);
  if (trace.size() == 0 || when > trace.times().back() + rounding) return std::nullopt;
  const auto [before, after, fraction] = trace.bracket(when);
  const Conserved conserved(scene);
  if (expectation.quantity == Quantity::energy_rise) return energy_rise(conserved, trace, after);
  std::optional<std::size_t> other;
  if (!expectation.other.empty()) other = index_of(scene, expectation.other);
  const auto at = [&](std::size_t moment) {
    if (expectation.quantity == Quantity::load) return load(trace, moment, body, other);
    return quantity_of(expectation.quantity, body, conserved, trace.states(moment));
  };
  if (expectation.over == 0) {
    const auto speed = speed_behind(expectation.quantity);
    if (!speed) return Observation{when, at(before) + fraction * (at(after) - at(before))};
    const auto changes = [&](std::size_t moment) { return quantity_of(*speed, body, conserved, trace.states(moment)); };
    const double T = trace.time(after) - trace.time(before);
    return Observation{when, between(at(before), at(after), changes(before), changes(after), T, fraction)};
  }
  // Each moment stands for the step that ends there; all steps of a trace have the same length.
  double sum = at(after);
  std::size_t moments = 1;
  for (std::size_t i = after; i-- > 1 && trace.time(i) > when - expectation.over + rounding; ++moments) sum += at(i);
  return Observation{when, sum / static_cast<double>(moments)};
}

Truth::Truth(const Engine& closed_form, const Scene& scene)
    : closed_form_(closed_form),
      scene_(scene),
      until_(closed_form.build(scene, complete(closed_form, {}))->valid_until()) {}

Truth::Truth(const Engine& closed_form, const Scene& scene, double until) : Truth(closed_form, scene) {
  until_ = std::min(until_, until);
}

std::optional<std::vector<BodyState>> Truth::at(double time) const {
  if (time > until_) return std::nullopt;
  const auto simulation = closed_form_.build(scene_, complete(closed_form_, {}));
  if (time > 0) simulation->step(time);
  std::vector<BodyState> states(scene_.bodies.size());
  simulation->read(states);
  return states;
}

std::optional<double> expected_value(const Scene& scene, const Expectation& expectation, const Truth* truth,
                                     double time) {
  if (expectation.expected) return expectation.expected;
  const auto states = truth == nullptr ? std::nullopt : truth->at(time);
  if (!states) return std::nullopt;
  const std::size_t body = expectation.body.empty() ? 0 : index_of(scene, expectation.body);
  return quantity_of(expectation.quantity, body, Conserved(scene), *states);
}

}  // namespace plumb
