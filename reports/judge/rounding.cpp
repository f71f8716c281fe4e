#include "reports/judge/rounding.h"

#include <algorithm>
#include <cmath>

#include "reports/judge/mechanics.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

// The largest values of a body over a run, in m, m/s, rad and rad/s.
struct Extremes {
  double position = 0, speed = 0, angle = 0, spin = 0;
};

Extremes extremes_of(const Trace& trace, std::size_t body) {
  Extremes extremes;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    const BodyState& state = trace.states(i)[body];
    extremes.position = std::max(extremes.position, length(state.position));
    extremes.speed = std::max(extremes.speed, length(state.velocity));
    extremes.angle = std::max(extremes.angle, std::abs(state.angle));
    extremes.spin = std::max(extremes.spin, std::abs(state.angular_velocity));
  }
  return extremes;
}

// s; of a trace that is only its start: any.
double shortest_step(const Trace& trace) {
  double shortest = trace.times().back() - trace.times().front();
  for (std::size_t i = 1; i < trace.size(); ++i) shortest = std::min(shortest, trace.time(i) - trace.time(i - 1));
  return shortest;
}

}  // namespace

double trace_rounding(const Trace& trace, const Stepping& stepping) {
  if (trace.size() == 0) return 0;
  const auto steps = static_cast<double>(trace.size() - 1);
  return ((stepping.h > 0 ? std::max(steps, trace.times().back() / stepping.h) : steps) + 2) * stepping.epsilon;
}

double solver_rounding(const Stepping& stepping) {
  constexpr double iterations = 64;
  return iterations * stepping.epsilon;
}

double differenced(const Stepping& stepping, double position, double step) {
  return stepping.differenced_velocities ? position / step : 0;
}

// With nu = trace_rounding:
//   velocity  dv <= nu v_max, or nu (v_max + x_max/dt) if it is kept as a difference of positions
//   position  dx <= nu x_max + t dv/2    (its own sum, plus the integral of the velocity's evenly growing error)
// and the same for spin and angle. Energy m v^2/2 + m g y and the momenta follow to first order.
double quantity_rounding(Quantity quantity, std::size_t body, const Scene& scene, const Trace& trace,
                         const Stepping& stepping) {
  if (trace.size() == 0) return 0;
  const double t = trace.times().back();
  const double nu = trace_rounding(trace, stepping);
  const double step = shortest_step(trace);
  const auto off = [&](const Extremes& of) {
    const double dv = nu * (of.speed + differenced(stepping, of.position, step));
    const double dw = nu * (of.spin + differenced(stepping, of.angle, step));
    return Extremes{nu * of.position + t * dv / 2, dv, nu * of.angle + t * dw / 2, dw};
  };
  const auto over_all = [&](auto&& of_one) {
    const Conserved conserved(scene);
    double sum = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Mass& mass = conserved.masses()[i];
      if (!(mass.mass > 0)) continue;
      const Extremes of = extremes_of(trace, i);
      sum += of_one(mass, of, off(of));
    }
    return sum;
  };
  switch (quantity) {
    case Quantity::x:
    case Quantity::y:
    case Quantity::apex:
      return off(extremes_of(trace, body)).position;
    case Quantity::vx:
    case Quantity::vy:
    case Quantity::speed:
      return off(extremes_of(trace, body)).speed;
    case Quantity::angle:
      return off(extremes_of(trace, body)).angle;
    case Quantity::angular_velocity:
      return off(extremes_of(trace, body)).spin;
    case Quantity::speed_spread:
      // About 2, a quotient of fourth powers of speeds that are each off by nu.
      return 16 * nu;
    case Quantity::landing:
      return nu * t;
    case Quantity::load:
      return nu *
             over_all([&](const Mass& m, const Extremes&, const Extremes&) { return m.mass * length(scene.gravity); });
    case Quantity::energy_rise:
      return 2 * quantity_rounding(Quantity::energy, body, scene, trace, stepping);
    case Quantity::energy:
      return over_all([&](const Mass& m, const Extremes& of, const Extremes& by) {
        return m.mass * (of.speed * by.speed + length(scene.gravity) * by.position) + m.inertia * of.spin * by.spin;
      });
    case Quantity::momentum_x:
    case Quantity::momentum_y:
      return over_all([](const Mass& m, const Extremes&, const Extremes& by) { return m.mass * by.speed; });
    case Quantity::angular_momentum:
      return over_all([](const Mass& m, const Extremes& of, const Extremes& by) {
        return m.mass * (of.position * by.speed + by.position * of.speed) + m.inertia * by.spin;
      });
  }
  return 0;
}

}  // namespace plumb
