#include "reports/prove/alarm.h"

#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "reports/judge/observe.h"
#include "reports/run/case_run.h"

namespace plumb {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// FNV-1a over the numbers' bits.
class Hash {
 public:
  void add(double number) {
    std::uint64_t bits = std::bit_cast<std::uint64_t>(number);
    for (int byte = 0; byte < 8; ++byte, bits >>= 8) value_ = (value_ ^ (bits & 0xff)) * 0x100000001b3;
  }
  void add(const Vec& v) {
    add(v.x);
    add(v.y);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

std::uint64_t bits_of(const Trace& trace) {
  Hash hash;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    for (const BodyState& state : trace.states(i)) {
      hash.add(state.position);
      hash.add(state.angle);
      hash.add(state.velocity);
      hash.add(state.angular_velocity);
    }
    for (const ContactState& contact : trace.contacts(i)) {
      hash.add(contact.point);
      hash.add(contact.normal_impulse);
      hash.add(contact.tangent_impulse);
    }
  }
  return hash.value();
}

Alarm alarm_of(const Case& asked, Means means, std::string metric) {
  return {.scenario = asked.scenario->name, .variant = asked.variant, .means = means, .metric = std::move(metric)};
}

}  // namespace

Examined examine_twice(const Case& asked, const EngineConfig& config, double dt) {
  const Scene& scene = *asked.scene;
  const Outcome outcome = run(scene, config, dt, asked.first_step);
  Examined examined{.status = outcome.status, .reason = outcome.reason};
  if (outcome.trace) examined.bits = bits_of(*outcome.trace);
  if (outcome.status != Status::ok) return examined;
  const Outcome again = run(scene, config, dt, asked.first_step);
  examined.same_twice = again.trace && bits_of(*again.trace) == examined.bits;
  std::optional<Truth> truth;
  if (asked.closed_form != nullptr && asked.closed_form->unsupported(scene, complete(*asked.closed_form, {})).empty()) {
    truth.emplace(*asked.closed_form, scene);
  }
  examined.judgement =
      judge_case(asked, config, dt, *outcome.trace, run_shifted(asked, config, dt), truth ? &*truth : nullptr);
  return examined;
}

const char* name_of(Means means) {
  switch (means) {
    case Means::truth:
      return "truth";
    case Means::invariant:
      return "invariant";
    case Means::repeat:
      return "not the same twice";
    case Means::bits:
      return "bits alone";
  }
  return "";
}

std::vector<Alarm> physics_alarms(const Case& asked, const Examined& right, const Examined& suspect) {
  std::vector<Alarm> all;
  if (right.status != Status::ok) return all;
  if (suspect.status != Status::ok) {
    Alarm lost = alarm_of(asked, Means::invariant, "the run's end");
    lost.ratio = infinite;
    return {lost};
  }
  const auto& checks = suspect.judgement.checks;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    if (!right.judgement.checks[i].passed || checks[i].passed || !checks[i].reported) continue;
    Alarm off = alarm_of(asked, Means::truth,
                         checks[i].body.empty() ? checks[i].quantity : checks[i].body + " " + checks[i].quantity);
    off.unit = checks[i].unit;
    off.off = checks[i].error;
    off.tolerance = checks[i].tolerance;
    off.ratio = error_ratio(checks[i].error, checks[i].tolerance);
    all.push_back(off);
  }
  const auto& invariants = suspect.judgement.invariants;
  for (std::size_t i = 0; i < invariants.size(); ++i) {
    const bool held = right.judgement.invariants[i].ratio <= 1;
    if (!held || !(invariants[i].ratio > 1)) continue;
    Alarm broken = alarm_of(asked, Means::invariant, invariants[i].name);
    broken.unit = invariants[i].unit;
    broken.off = invariants[i].value;
    broken.tolerance = invariants[i].tolerance;
    broken.ratio = invariants[i].ratio;
    all.push_back(broken);
  }
  return all;
}

std::vector<Alarm> alarms(const Case& asked, const Examined& right, const Examined& suspect) {
  std::vector<Alarm> all = physics_alarms(asked, right, suspect);
  if (right.status != Status::ok) return all;
  if (right.same_twice && !suspect.same_twice) {
    Alarm other = alarm_of(asked, Means::repeat, "bits of two runs");
    other.ratio = infinite;
    all.push_back(other);
  }
  if (all.empty() && suspect.bits != right.bits) all.push_back(alarm_of(asked, Means::bits, "bits"));
  return all;
}

}  // namespace plumb
