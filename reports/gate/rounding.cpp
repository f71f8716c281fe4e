#include "reports/gate/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/judge/mechanics.h"
#include "reports/vec.h"
#include "scenarios/scene/mass.h"

namespace plumb {

// A number that is rounded n times, by u of its size each and either way, is off by sqrt(n) u of it: roundings walk at
// random (Higham 2002, section 2.8). A speed's error is carried along for the time t. A contact turns the rounding of
// places into a speed, by dividing by the step, anew in each step, and over an arm into a turn (see compare/tolerance.cpp).
Rounding::Rounding(const Scene& scene, const Trace& trace, const Stepping& stepping) {
  if (trace.size() < 2) return;
  double speed = 0, turn = 0, spin = 0, impulse = 0, gap = 0;
  for (std::size_t moment = 0; moment < trace.size(); ++moment) {
    for (const BodyState& state : trace.states(moment)) {
      largest_ = std::max(largest_, length(state.position));
      speed = std::max(speed, length(state.velocity));
      turn = std::max(turn, std::abs(state.angle));
      spin = std::max(spin, std::abs(state.angular_velocity));
    }
    for (const ContactState& contact : trace.contacts(moment)) {
      impulse = std::max(impulse, std::hypot(contact.normal_impulse, contact.tangent_impulse));
      gap = std::max(gap, std::abs(contact.separation));
    }
  }
  double mass = 0, inertia = 0, arm = 1;  // m, the smallest radius of gyration
  for (const Body& body : scene.bodies) {
    const Mass of = mass_of(body);
    mass += of.mass;
    inertia += of.inertia;
    if (of.inertia > 0) arm = std::min(arm, std::sqrt(of.inertia / of.mass));
  }
  h_ = stepping.h > 0 ? stepping.h : trace.time(1) - trace.time(0);
  const double t = trace.times().back();
  // A closed form states no arithmetic; it is evaluated in double.
  const double u = stepping.epsilon > 0 ? stepping.epsilon : std::numeric_limits<double>::epsilon();
  const double share = std::sqrt(t / h_ + 1) * u;
  const double gravity = length(scene.gravity);
  // What rests has its weight's g h added and taken away again.
  const double moving = speed + gravity * h_;
  const double pushed = u * largest_ / h_;
  velocity_ = share * moving + pushed;
  position_ = share * (largest_ + moving * t);
  spin_ = share * (spin + moving / arm) + pushed / arm;
  turn_ = share * (turn + (spin + moving / arm) * t + largest_ / arm);
  momentum_ = mass * velocity_;
  angular_momentum_ = mass * (largest_ * velocity_ + speed * position_) + inertia * spin_;
  energy_ = mass * (speed * velocity_ + gravity * position_) + inertia * spin * spin_;
  const double range = energy_range(scene, nullptr);
  energy_share_ = range > 0 ? energy_ / range : 0;
  if (speed > 0) energy_share_ += 16 * velocity_ / speed;  // a quotient of fourth powers of speeds, 2 or so
  impulse_gap_ = momentum_ * gap + impulse * position_;
}

double Rounding::of(const std::string& unit) const {
  if (unit == "m") return position_;
  if (unit == "m/s") return velocity_;
  if (unit == "rad") return turn_;
  if (unit == "rad/s") return spin_;
  if (unit == "J") return energy_;
  if (unit == "1") return energy_share_;
  if (unit == "N s" || unit == "kg m/s") return momentum_;
  if (unit == "kg m^2/s") return angular_momentum_;
  if (unit == "N") return momentum_ / h_;
  if (unit == "N m") return (momentum_ * largest_ + impulse_gap_) / h_;
  if (unit == "N s m") return impulse_gap_;
  return 0;
}

}  // namespace plumb
