#include "reports/compare/same_enough.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/vec.h"
#include "scenarios/allowance.h"
#include "scenarios/scene/mass.h"

namespace plumb {

SameEnough within(double tolerance, const Scene& scene) {
  double lightest = std::numeric_limits<double>::infinity();
  for (const Body& body : scene.bodies) {
    const double mass = mass_of(body).mass;
    if (mass > 0) lightest = std::min(lightest, mass);
  }
  return {tolerance, tolerance, tolerance, tolerance, lightest * tolerance};
}

RoundOff::RoundOff(const Scene& scene, const Stepping& a, const Stepping& b) : scene_(scene), a_(a), b_(b) {
  bool first = true;
  for (const Body& body : scene.bodies) {
    const Mass of = mass_of(body);
    mass_ += of.mass;
    if (of.inertia <= 0) continue;
    const double gyration = std::sqrt(of.inertia / of.mass);
    short_ = first ? gyration : std::min(short_, gyration);
    long_ = std::max(long_, gyration);
    first = false;
  }
}

void RoundOff::meet(std::span<const BodyState> states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (scene_.bodies[i].type == BodyType::fixed) continue;
    place_ = std::max(place_, length(states[i].position));
    turn_ = std::max(turn_, std::abs(states[i].angle));
    speed_ = std::max(speed_, length(states[i].velocity));
    spin_ = std::max(spin_, std::abs(states[i].angular_velocity));
  }
}

// Every step rounds speeds and places (see round_off). What rests has its weight's g dt added and taken away again, and
// contacts turn speed into spin and back over an arm: so large are the numbers that are rounded. A contact also turns
// the rounding of places, of which its separation is the difference, into a speed by dividing by the step, anew in each
// step, and over an arm into a turn; and an impulse gives at most the whole mass such a speed.
SameEnough RoundOff::at(double time, std::span<const BodyState> a, std::span<const BodyState> b) {
  meet(a);
  meet(b);
  SameEnough all;
  for (const Stepping& s : {a_, b_}) {
    const double moving = speed_ + length(scene_.gravity) * s.dt + spin_ * long_;
    const double turning = spin_ + moving / short_;
    const double pushed = 4 * s.epsilon * place_ / (s.h > 0 ? s.h : s.dt);
    all.position += round_off(s, time, place_ + moving * time);
    all.angle += round_off(s, time, turn_ + turning * time + place_ / short_);
    all.velocity += round_off(s, time, moving) + pushed;
    all.spin += round_off(s, time, turning) + pushed / short_;
  }
  all.impulse = mass_ * all.velocity;
  return all;
}

}  // namespace plumb
