#include "reports/compare/divergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "reports/report.h"
#include "scenarios/allowance.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

// A component of a body's state, and the tolerance that applies to it.
struct StateComponent {
  const char* name;
  const char* unit;
  double (*of)(const BodyState&);
  double StateTolerance::*tolerance;
};

constexpr StateComponent state_components[] = {
    {"x", "m", [](const BodyState& s) { return s.position.x; }, &StateTolerance::position},
    {"y", "m", [](const BodyState& s) { return s.position.y; }, &StateTolerance::position},
    {"angle", "rad", [](const BodyState& s) { return s.angle; }, &StateTolerance::angle},
    {"vx", "m/s", [](const BodyState& s) { return s.velocity.x; }, &StateTolerance::velocity},
    {"vy", "m/s", [](const BodyState& s) { return s.velocity.y; }, &StateTolerance::velocity},
    {"angular velocity", "rad/s", [](const BodyState& s) { return s.angular_velocity; }, &StateTolerance::spin},
};

// The body and component with the largest error ratio.
struct LargestDifference {
  std::size_t body = 0;
  const StateComponent* component = nullptr;
  double ratio = -1;
};

class TraceComparer {
 public:
  TraceComparer(const Scene& scene, const ComparedRun& a, const ComparedRun& b, std::optional<double> tolerance)
      : scene_(scene), a_(a), b_(b), moments_(std::min(a.trace->size(), b.trace->size())) {
    RoundOffTolerance by_round_off(scene, a.stepping, b.stepping);
    for (std::size_t k = 0; k < moments_; ++k) {
      const double time = a.trace->time(k);
      if (time != b.trace->time(k)) throw std::invalid_argument("two runs can only be compared at the same moments");
      tolerances_.push_back(tolerance ? uniform_tolerance(*tolerance, scene)
                                      : by_round_off.at(time, a.trace->states(k), b.trace->states(k)));
    }
  }

  TraceComparison compare() const {
    TraceComparison result;
    if (moments_ == 0) return result;
    result.steps = moments_ - 1;
    result.until = a_.trace->time(moments_ - 1);
    LargestDifference largest;
    std::size_t when = 0;
    for (std::size_t k = 0; k < moments_; ++k) {
      const LargestDifference now = largest_at(k);
      if (now.ratio > 1) {
        result.divergence = divergence_at(k, now);
        return result;
      }
      if (now.ratio <= largest.ratio) continue;
      largest = now;
      when = k;
    }
    if (largest.component != nullptr) result.largest = value_of(*largest.component, largest.body, when);
    return result;
  }

 private:
  double difference(const StateComponent& component, std::size_t body, std::size_t k) const {
    return std::abs(component.of(a_.trace->states(k)[body]) - component.of(b_.trace->states(k)[body]));
  }

  ValueDifference value_of(const StateComponent& component, std::size_t body, std::size_t k) const {
    return {.what = fmt::format("{} of {}", component.name, scene_.bodies[body].name),
            .unit = component.unit,
            .a = component.of(a_.trace->states(k)[body]),
            .b = component.of(b_.trace->states(k)[body]),
            .difference = difference(component, body, k),
            .tolerance = tolerances_[k].*component.tolerance};
  }

  LargestDifference largest_at(std::size_t k) const {
    LargestDifference largest;
    for (std::size_t body = 0; body < scene_.bodies.size(); ++body) {
      if (scene_.bodies[body].type == BodyType::fixed) continue;
      for (const StateComponent& component : state_components) {
        const double ratio = error_ratio(difference(component, body, k), tolerances_[k].*component.tolerance);
        if (ratio > largest.ratio) largest = {body, &component, ratio};
      }
    }
    return largest;
  }

  Divergence divergence_at(std::size_t k, const LargestDifference& largest) const {
    Divergence divergence{.step = k,
                          .time = a_.trace->time(k),
                          .body = scene_.bodies[largest.body].name,
                          .first = value_of(*largest.component, largest.body, k)};
    for (const StateComponent& component : state_components) {
      divergence.values.push_back(value_of(component, largest.body, k));
    }
    if (k == 0) {
      divergence.stage = Stage::start;
      divergence.advice = "They do not start from the same state: look at how each adapter places the body.";
    } else {
      ContactCause cause = find_contact_cause(scene_, a_, b_, k, largest.body, tolerances_[k]);
      divergence.stage = cause.stage;
      divergence.other = cause.other;
      divergence.advice = cause.advice;
      if (cause.stage == Stage::integration) divergence.advice += explain_by_drift(k, largest, divergence.first);
      const double before = difference(*largest.component, largest.body, k - 1);
      if (before > divergence.first.difference / 2) {
        divergence.advice +=
            " Most of the difference was there a step earlier: a smaller tolerance finds where it began.";
      }
      for (ValueDifference& value : cause.values) divergence.values.push_back(std::move(value));
    }
    divergence.growth = growth(k, *largest.component);
    return divergence;
  }

  // Free fall is off by drift g t h (see Stepping), so two integrators differ by the difference of theirs, within
  // rounding.
  std::string explain_by_drift(std::size_t k, const LargestDifference& largest, const ValueDifference& value) const {
    const double drift = a_.stepping.drift * a_.stepping.h - b_.stepping.drift * b_.stepping.h;
    const Vec g = scene_.bodies[largest.body].gravity_scale * scene_.gravity;
    const double along = largest.component->of({.position = g});  // 0 except for x and y
    const double predicted = std::abs(drift * along) * a_.trace->time(k);
    if (predicted == 0 || std::abs(value.difference - predicted) > value.tolerance) return "";
    return fmt::format(" Their integrators explain it: by their stated drifts, free fall differs by {:.3g} m here.",
                       predicted);
  }

  // The largest difference of all bodies in this kind of component; positions and velocities count as vectors.
  double vector_difference(std::size_t k, const StateComponent& component) const {
    double largest = 0;
    for (std::size_t body = 0; body < scene_.bodies.size(); ++body) {
      if (scene_.bodies[body].type == BodyType::fixed) continue;
      double squares = 0;
      for (const StateComponent& other : state_components) {
        if (other.tolerance != component.tolerance) continue;
        const double one = difference(other, body, k);
        squares += one * one;
      }
      largest = std::max(largest, std::sqrt(squares));
    }
    return largest;
  }

  std::vector<DivergenceGrowth> growth(std::size_t first, const StateComponent& component) const {
    const double start = vector_difference(first, component);
    std::vector<DivergenceGrowth> all;
    double factor = 1;
    for (std::size_t k = first; k < moments_; ++k) {
      const double now = vector_difference(k, component);
      if (now >= factor * start) all.push_back({now / start, k, a_.trace->time(k), now});
      while (now >= factor * start) factor *= 10;
    }
    const std::size_t last = moments_ - 1;
    if (all.back().step != last) {
      const double end = vector_difference(last, component);
      all.push_back({end / start, last, a_.trace->time(last), end});
    }
    return all;
  }

  const Scene& scene_;
  const ComparedRun& a_;
  const ComparedRun& b_;
  std::size_t moments_;
  std::vector<StateTolerance> tolerances_;  // by moment
};

}  // namespace

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

TraceComparison compare_traces(const Scene& scene, const ComparedRun& a, const ComparedRun& b,
                               std::optional<double> tolerance) {
  if (a.trace->bodies() != scene.bodies.size() || b.trace->bodies() != scene.bodies.size()) {
    throw std::invalid_argument("two runs can only be compared over one scene");
  }
  return TraceComparer(scene, a, b, tolerance).compare();
}

}  // namespace plumb
