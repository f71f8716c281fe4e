#include "reports/judge/observe.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "reports/vec.h"
#include "scenarios/scene/nearest.h"

namespace plumb {
namespace {

// Through (-1, a), (0, b), (1, c): y(s) = b + (c-a) s/2 + (a-2b+c) s^2/2, highest at s = (a-c)/(2 (a-2b+c)).
Reading vertex(double time, double step, double a, double b, double c) {
  const double bend = a - 2 * b + c;
  const double s = (a - c) / (2 * bend);
  return {time + s * step, b - (c - a) * (c - a) / (8 * bend)};
}

std::optional<Reading> apex(const Trace& trace, std::size_t body, int index) {
  const auto y = [&](std::size_t moment) { return trace.states(moment)[body].position.y; };
  int seen = 0;
  for (std::size_t i = 1; i + 1 < trace.size(); ++i) {
    const bool highest = y(i - 1) < y(i) && y(i) >= y(i + 1);
    if (highest && ++seen == index) {
      return vertex(trace.time(i), trace.time(i) - trace.time(i - 1), y(i - 1), y(i), y(i + 1));
    }
  }
  return std::nullopt;
}

std::optional<Reading> landing(const Trace& trace, std::size_t body, int index) {
  const auto y = [&](std::size_t moment) { return trace.states(moment)[body].position.y; };
  int seen = 0;
  for (std::size_t i = 1; i + 1 < trace.size(); ++i) {
    const bool lowest = y(i - 1) > y(i) && y(i) <= y(i + 1);
    if (lowest && ++seen == index) return Reading{trace.time(i), trace.time(i)};
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

// Impulses of the last step over its length; a body that is not named is any.
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

Reading energy_rise(const Conserved& conserved, const Trace& trace, std::size_t last) {
  double lowest = conserved.energy(trace.states(0)).total();
  Reading most{trace.time(0), 0};
  for (std::size_t i = 1; i <= last; ++i) {
    const double energy = conserved.energy(trace.states(i)).total();
    if (energy - lowest > most.value) most = {trace.time(i), energy - lowest};
    lowest = std::min(lowest, energy);
  }
  return most;
}

bool reports(const Trace& trace, Quantity quantity) {
  if (quantity != Quantity::load) return true;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    if (!trace.contacts(i).empty()) return true;
  }
  return false;
}

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
  throw std::invalid_argument(std::string(name_of(quantity)) + " belongs to a trace, not to a moment");
}

std::optional<Reading> observe(const Scene& scene, const Trace& trace, const Expectation& expectation, double time) {
  const std::size_t body = expectation.body.empty() ? 0 : index_of(scene, expectation.body);
  if (expectation.quantity == Quantity::apex) return apex(trace, body, expectation.index);
  if (expectation.quantity == Quantity::landing) return landing(trace, body, expectation.index);
  const double when = expectation.time.value_or(time);
  // The last step ends at the scene's end but for the rounding of steps times dt.
  const double rounding = 1e-9 * std::abs(when);
  if (trace.size() == 0 || when > trace.times().back() + rounding) return std::nullopt;
  const auto [before, after, share] = trace.around(when);
  const Conserved conserved(scene);
  if (expectation.quantity == Quantity::energy_rise) return energy_rise(conserved, trace, after);
  std::optional<std::size_t> other;
  if (!expectation.other.empty()) other = index_of(scene, expectation.other);
  const auto at = [&](std::size_t moment) {
    if (expectation.quantity == Quantity::load) return load(trace, moment, body, other);
    return quantity_of(expectation.quantity, body, conserved, trace.states(moment));
  };
  if (expectation.over == 0) return Reading{when, at(before) + share * (at(after) - at(before))};
  // Each moment stands for the step that led to it: all steps of a trace are equally long.
  double sum = at(after);
  std::size_t moments = 1;
  for (std::size_t i = after; i-- > 1 && trace.time(i) > when - expectation.over + rounding; ++moments) sum += at(i);
  return Reading{when, sum / static_cast<double>(moments)};
}

}  // namespace plumb
