#include "reports/compare/tolerance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/allowance.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"

namespace plumb {

StateTolerance uniform_tolerance(double tolerance, const Scene& scene) {
  double lightest = std::numeric_limits<double>::infinity();
  for (const Body& body : scene.bodies) {
    const double mass = mass_of(body).mass;
    if (mass > 0) lightest = std::min(lightest, mass);
  }
  return {tolerance, tolerance, tolerance, tolerance, lightest * tolerance};
}

RoundOffTolerance::RoundOffTolerance(const Scene& scene, const Stepping& a, const Stepping& b)
    : scene_(scene), a_(a), b_(b) {
  bool first = true;
  for (const Body& body : scene.bodies) {
    const Mass of = mass_of(body);
    mass_ += of.mass;
    if (of.inertia <= 0) continue;
    const double gyration = std::sqrt(of.inertia / of.mass);
    smallest_radius_ = first ? gyration : std::min(smallest_radius_, gyration);
    largest_radius_ = std::max(largest_radius_, gyration);
    first = false;
  }
}

void RoundOffTolerance::include(std::span<const BodyState> states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (scene_.bodies[i].type == BodyType::fixed) continue;
    position_ = std::max(position_, length(states[i].position));
    angle_ = std::max(angle_, std::abs(states[i].angle));
    speed_ = std::max(speed_, length(states[i].velocity));
    spin_ = std::max(spin_, std::abs(states[i].angular_velocity));
  }
}

// Every step rounds velocities and positions (see round_off in scenarios/allowance.h). A body at rest gets g dt added
// and removed in every step, and contacts convert speed to spin and back over an arm, so these sizes are rounded too. A
// contact also turns the rounding of positions, whose difference is its separation, into a velocity by dividing by the
// step, anew in each step, and over an arm into a spin. An impulse gives at most the whole mass such a velocity.
StateTolerance RoundOffTolerance::at(double time, std::span<const BodyState> a, std::span<const BodyState> b) {
  include(a);
  include(b);
  StateTolerance all;
  for (const Stepping& s : {a_, b_}) {
    const double moving = speed_ + length(scene_.gravity) * s.dt + spin_ * largest_radius_;
    const double rotating = spin_ + moving / smallest_radius_;
    const double pushed = 4 * s.epsilon * position_ / (s.h > 0 ? s.h : s.dt);
    all.position += round_off(s, time, position_ + moving * time);
    all.angle += round_off(s, time, angle_ + rotating * time + position_ / smallest_radius_);
    all.velocity += round_off(s, time, moving) + pushed;
    all.spin += round_off(s, time, rotating) + pushed / smallest_radius_;
  }
  all.impulse = mass_ * all.velocity;
  return all;
}

}  // namespace plumb
