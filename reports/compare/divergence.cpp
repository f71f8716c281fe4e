#include "reports/compare/divergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reports/compare/parting_contact.h"
#include "reports/compare/same_enough.h"
#include "reports/vec.h"

namespace plumb {
namespace {

// A number of a body's state, and how far two runs may differ in it.
struct StateNumber {
  const char* name;
  const char* unit;
  double (*of)(const BodyState&);
  double SameEnough::*tolerance;
};

constexpr StateNumber state_numbers[] = {
    {"x", "m", [](const BodyState& s) { return s.position.x; }, &SameEnough::position},
    {"y", "m", [](const BodyState& s) { return s.position.y; }, &SameEnough::position},
    {"angle", "rad", [](const BodyState& s) { return s.angle; }, &SameEnough::angle},
    {"vx", "m/s", [](const BodyState& s) { return s.velocity.x; }, &SameEnough::velocity},
    {"vy", "m/s", [](const BodyState& s) { return s.velocity.y; }, &SameEnough::velocity},
    {"angular velocity", "rad/s", [](const BodyState& s) { return s.angular_velocity; }, &SameEnough::spin},
};

// The number in which one body's states differ the most, against what is allowed.
struct Worst {
  std::size_t body = 0;
  const StateNumber* number = nullptr;
  double share = -1;  // of what is allowed
};

class StepComparison {
 public:
  StepComparison(const Scene& scene, const Side& a, const Side& b, std::optional<double> tolerance)
      : scene_(scene), a_(a), b_(b), moments_(std::min(a.trace->size(), b.trace->size())) {
    RoundOff round_off(scene, a.stepping, b.stepping);
    for (std::size_t k = 0; k < moments_; ++k) {
      const double time = a.trace->time(k);
      if (time != b.trace->time(k)) throw std::invalid_argument("two runs are compared at the same moments only");
      allowed_.push_back(tolerance ? within(*tolerance, scene)
                                   : round_off.at(time, a.trace->states(k), b.trace->states(k)));
    }
  }

  Compared compare() const {
    Compared compared;
    if (moments_ == 0) return compared;
    compared.steps = moments_ - 1;
    compared.until = a_.trace->time(moments_ - 1);
    Worst nearest;
    std::size_t when = 0;
    for (std::size_t k = 0; k < moments_; ++k) {
      const Worst worst = worst_at(k);
      if (worst.share > 1) {
        compared.parted = parted_at(k, worst);
        return compared;
      }
      if (worst.share <= nearest.share) continue;
      nearest = worst;
      when = k;
    }
    if (nearest.number != nullptr) compared.largest = figure_of(*nearest.number, nearest.body, when);
    return compared;
  }

 private:
  double difference(const StateNumber& number, std::size_t body, std::size_t k) const {
    return std::abs(number.of(a_.trace->states(k)[body]) - number.of(b_.trace->states(k)[body]));
  }

  Figure figure_of(const StateNumber& number, std::size_t body, std::size_t k) const {
    return {.what = fmt::format("{} of {}", number.name, scene_.bodies[body].name),
            .unit = number.unit,
            .a = number.of(a_.trace->states(k)[body]),
            .b = number.of(b_.trace->states(k)[body]),
            .difference = difference(number, body, k),
            .tolerance = allowed_[k].*number.tolerance};
  }

  Worst worst_at(std::size_t k) const {
    Worst worst;
    for (std::size_t body = 0; body < scene_.bodies.size(); ++body) {
      if (scene_.bodies[body].type == BodyType::fixed) continue;
      for (const StateNumber& number : state_numbers) {
        const double apart = difference(number, body, k);
        const double share = apart == 0 ? 0 : apart / (allowed_[k].*number.tolerance);
        if (share > worst.share) worst = {body, &number, share};
      }
    }
    return worst;
  }

  Divergence parted_at(std::size_t k, const Worst& worst) const {
    Divergence parted{.step = k,
                      .time = a_.trace->time(k),
                      .body = scene_.bodies[worst.body].name,
                      .first = figure_of(*worst.number, worst.body, k)};
    for (const StateNumber& number : state_numbers) parted.figures.push_back(figure_of(number, worst.body, k));
    if (k == 0) {
      parted.stage = Stage::start;
      parted.advice = "They do not begin from the same state: look at how each adapter places the body.";
    } else {
      PartingContact contact = parting_contact(scene_, a_, b_, k, worst.body, allowed_[k]);
      parted.stage = contact.stage;
      parted.other = contact.other;
      parted.advice = contact.advice;
      if (contact.stage == Stage::integration) parted.advice += drift_explains(k, worst, parted.first);
      // What was there before did not come about in this step.
      const double before = difference(*worst.number, worst.body, k - 1);
      if (before > parted.first.difference / 2) {
        parted.advice += " Most of the difference was there a step before: a smaller tolerance finds where it began.";
      }
      for (Figure& figure : contact.figures) parted.figures.push_back(std::move(figure));
    }
    parted.growth = growth(k, *worst.number);
    return parted;
  }

  // Free fall is off by drift g t h (see Stepping), so two integrators differ by the difference of that; both terms
  // round, as does what they are compared with.
  std::string drift_explains(std::size_t k, const Worst& worst, const Figure& figure) const {
    const double drift = a_.stepping.drift * a_.stepping.h - b_.stepping.drift * b_.stepping.h;
    const Vec g = scene_.bodies[worst.body].gravity_scale * scene_.gravity;
    const double along = worst.number->of({.position = g});  // 0 but for x and y
    const double predicted = std::abs(drift * along) * a_.trace->time(k);
    if (predicted == 0 || std::abs(figure.difference - predicted) > figure.tolerance) return "";
    return fmt::format(" Their integrators explain it: by what they state, free fall differs by {:.3g} m here.",
                       predicted);
  }

  // The largest difference of all bodies in that kind of number; places and velocities count as vectors.
  double apart(std::size_t k, const StateNumber& number) const {
    double largest = 0;
    for (std::size_t body = 0; body < scene_.bodies.size(); ++body) {
      if (scene_.bodies[body].type == BodyType::fixed) continue;
      double squares = 0;
      for (const StateNumber& kin : state_numbers) {
        if (kin.tolerance != number.tolerance) continue;
        const double one = difference(kin, body, k);
        squares += one * one;
      }
      largest = std::max(largest, std::sqrt(squares));
    }
    return largest;
  }

  std::vector<Growth> growth(std::size_t first, const StateNumber& number) const {
    const double start = apart(first, number);
    std::vector<Growth> all;
    double factor = 1;
    for (std::size_t k = first; k < moments_; ++k) {
      const double now = apart(k, number);
      if (now >= factor * start) all.push_back({now / start, k, a_.trace->time(k), now});
      while (now >= factor * start) factor *= 10;
    }
    const std::size_t last = moments_ - 1;
    if (all.back().step != last) {
      const double end = apart(last, number);
      all.push_back({end / start, last, a_.trace->time(last), end});
    }
    return all;
  }

  const Scene& scene_;
  const Side& a_;
  const Side& b_;
  std::size_t moments_;
  std::vector<SameEnough> allowed_;  // by moment
};

}  // namespace

const char* name_of(Stage stage) {
  switch (stage) {
    case Stage::start:
      return "start";
    case Stage::integration:
      return "integration";
    case Stage::event_time:
      return "event time";
    case Stage::contact_set:
      return "contact set";
    case Stage::manifold:
      return "manifold";
    case Stage::impulse:
      return "impulse";
    case Stage::not_reported:
      return "not reported";
  }
  return "";
}

Compared compare_steps(const Scene& scene, const Side& a, const Side& b, std::optional<double> tolerance) {
  if (a.trace->bodies() != scene.bodies.size() || b.trace->bodies() != scene.bodies.size()) {
    throw std::invalid_argument("two runs are compared over one scene only");
  }
  return StepComparison(scene, a, b, tolerance).compare();
}

}  // namespace plumb
