#include "reports/judge/verdict.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "reports/judge/conserved.h"
#include "reports/judge/invariant.h"
#include "reports/judge/observe.h"
#include "reports/judge/roundings.h"
#include "reports/vec.h"

namespace plumb {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// The largest values that a body went through.
struct Extent {
  double position = 0, speed = 0, angle = 0, spin = 0;
};

Extent extent_of(const Trace& trace, std::size_t body) {
  Extent extent;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    const BodyState& state = trace.states(i)[body];
    extent.position = std::max(extent.position, length(state.position));
    extent.speed = std::max(extent.speed, length(state.velocity));
    extent.angle = std::max(extent.angle, std::abs(state.angle));
    extent.spin = std::max(extent.spin, std::abs(state.angular_velocity));
  }
  return extent;
}

double expected_by(const Truth* truth, const Scene& scene, const Expectation& expectation, double time) {
  if (expectation.expected) return *expectation.expected;
  const auto states = truth == nullptr ? std::nullopt : truth->at(time);
  if (!states) return missing;
  const std::size_t body = expectation.body.empty() ? 0 : index_of(scene, expectation.body);
  return quantity_of(expectation.quantity, body, Conserved(scene), *states);
}

// By how much a value misses what it must be; 0 where it is on the right side.
double missed_by(Relation relation, double measured, double expected) {
  switch (relation) {
    case Relation::equal:
      return std::abs(measured - expected);
    case Relation::at_least:
      return measured >= expected ? 0 : expected - measured;
    case Relation::at_most:
      return measured <= expected ? 0 : measured - expected;
  }
  return missing;
}

TruthCheck check(const Scene& scene, const Expectation& expectation, const Trace& trace, const Stepping& stepping,
                 const Truth* truth) {
  const auto reading = observe(scene, trace, expectation, scene.duration);
  const double time = reading ? reading->time : expectation.time.value_or(scene.duration);
  const std::size_t body = expectation.body.empty() ? 0 : index_of(scene, expectation.body);
  const double tolerance = expectation.within ? *expectation.within
                                              : (expectation.allowed ? expectation.allowed(stepping) : 0) +
                                                    round_off(expectation.quantity, body, scene, trace, stepping);
  TruthCheck check{.body = expectation.body,
                   .quantity = name_of(expectation.quantity),
                   .unit = unit_of(expectation.quantity),
                   .time = time,
                   .relation = expectation.relation,
                   .expected = expected_by(truth, scene, expectation, time),
                   .measured = reading ? reading->value : missing,
                   .tolerance = tolerance,
                   .reported = reports(trace, expectation.quantity),
                   .source = expectation.source};
  if (!check.reported) check.measured = missing;
  check.error = missed_by(check.relation, check.measured, check.expected);
  // An infinite tolerance, or a bound beyond all numbers, would pass anything.
  const double numbers[] = {check.tolerance, check.measured, check.expected};
  check.passed = std::all_of(std::begin(numbers), std::end(numbers), [](double one) { return std::isfinite(one); }) &&
                 check.error <= check.tolerance;
  return check;
}

}  // namespace

// With nu the share that roundings take (see roundings.h):
//   velocity  dv <= nu v_max
//   position  dx <= nu x_max + t dv/2    (its own sum, and the velocity's error, growing evenly, carried along)
// and the same for spin and angle. Energy m v^2/2 + m g y and the momenta follow to first order.
double round_off(Quantity quantity, std::size_t body, const Scene& scene, const Trace& trace,
                 const Stepping& stepping) {
  if (trace.size() == 0) return 0;
  const double t = trace.times().back();
  const double nu = roundings(trace, stepping);
  const auto off = [&](std::size_t i) {
    const Extent of = extent_of(trace, i);
    const double dv = nu * of.speed;
    const double dw = nu * of.spin;
    return Extent{nu * of.position + t * dv / 2, dv, nu * of.angle + t * dw / 2, dw};
  };
  const auto over_all = [&](auto&& of_one) {
    const Conserved conserved(scene);
    double sum = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Mass& mass = conserved.masses()[i];
      if (mass.mass > 0) sum += of_one(mass, extent_of(trace, i), off(i));
    }
    return sum;
  };
  switch (quantity) {
    case Quantity::x:
    case Quantity::y:
    case Quantity::apex:
      return off(body).position;
    case Quantity::vx:
    case Quantity::vy:
    case Quantity::speed:
      return off(body).speed;
    case Quantity::angle:
      return off(body).angle;
    case Quantity::angular_velocity:
      return off(body).spin;
    case Quantity::speed_spread:
      // A quotient of fourth powers, 2 or so, of speeds that are each off by nu.
      return 16 * nu;
    case Quantity::landing:
      return nu * t;
    case Quantity::load:
      return nu * over_all([&](const Mass& m, const Extent&, const Extent&) { return m.mass * length(scene.gravity); });
    case Quantity::energy_rise:
      return 2 * round_off(Quantity::energy, body, scene, trace, stepping);
    case Quantity::energy:
      return over_all([&](const Mass& m, const Extent& of, const Extent& by) {
        return m.mass * (of.speed * by.speed + length(scene.gravity) * by.position) + m.inertia * of.spin * by.spin;
      });
    case Quantity::momentum_x:
    case Quantity::momentum_y:
      return over_all([](const Mass& m, const Extent&, const Extent& by) { return m.mass * by.speed; });
    case Quantity::angular_momentum:
      return over_all([](const Mass& m, const Extent& of, const Extent& by) {
        return m.mass * (of.position * by.speed + by.position * of.speed) + m.inertia * by.spin;
      });
  }
  return 0;
}

// What is broken is wrong whatever the truth says. Where motions can no longer be predicted, that comes between the
// two.
Verdict concluded(std::span<const TruthCheck> readings, std::span<const InvariantCheck> invariants) {
  const auto broken = [](const InvariantCheck& one) { return one.status == CheckStatus::broken; };
  const auto failed = [](const TruthCheck& one) { return one.reported && !one.passed; };
  const auto passed = [](const TruthCheck& one) { return one.passed; };
  if (std::any_of(invariants.begin(), invariants.end(), broken)) return Verdict::wrong;
  if (std::any_of(readings.begin(), readings.end(), failed)) return Verdict::wrong;
  return std::any_of(readings.begin(), readings.end(), passed) ? Verdict::right : Verdict::plausible;
}

Judgement judge(const Scene& scene, std::span<const Expectation> expectations, const Trace& trace,
                const Stepping& stepping, const Truth* truth) {
  Judgement judgement;
  for (const Expectation& expectation : expectations) {
    judgement.checks.push_back(check(scene, expectation, trace, stepping, truth));
  }
  judgement.invariants = check_invariants({scene, trace, stepping});
  judgement.verdict = concluded(judgement.checks, judgement.invariants);
  return judgement;
}

}  // namespace plumb
