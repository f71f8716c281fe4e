#include "reports/gate/bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "reports/judge/mechanics.h"
#include "reports/run/case_run.h"
#include "reports/system/jobs.h"
#include "scenarios/images.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

constexpr int perturbed_runs = 16;

// Two draws from a normal distribution whose standard deviation s is estimated from `perturbed_runs` + 1 others differ
// by more than this many s in one case in a million: sqrt(2) times Student's t with 16 degrees of freedom, at
// 1 - 5e-7. A hundred runs have a few thousand numbers, and at most one in a hundred such reports from another platform
// should raise a false alarm.
const double far_apart = std::sqrt(2.0) * 7.6415;

// m, the size of the perturbation: eight units of round-off of a body's position, as in horizon.h, but without the
// lower limit of 1e-9 m, so that what is right to round-off stays right.
double perturbation_of(const Scene& scene, const Stepping& stepping) {
  double farthest = 1;  // m
  for (const Body& body : scene.bodies) {
    if (body.type == BodyType::dynamic) farthest = std::max(farthest, length(body.position));
  }
  return 8 * stepping.epsilon * farthest;
}

double variance(double value, const std::vector<const BaselineNumber*>& others) {
  if (others.empty()) return 0;
  double sum = value;
  for (const BaselineNumber* one : others) sum += one->value;
  const double mean = sum / static_cast<double>(others.size() + 1);
  double squares = (value - mean) * (value - mean);
  for (const BaselineNumber* one : others) squares += (one->value - mean) * (one->value - mean);
  return squares / static_cast<double>(others.size());
}

// The number of this name in each perturbed run; null if a run does not have it.
std::vector<const BaselineNumber*> numbers_called(const std::string& name, const std::vector<BaselineRun>& perturbed) {
  std::vector<const BaselineNumber*> all;
  for (const BaselineRun& run : perturbed) {
    const auto found = run.numbers.find(name);
    all.push_back(found == run.numbers.end() ? nullptr : &found->second);
  }
  return all;
}

double bound_of(const BaselineNumber& number, const std::vector<const BaselineNumber*>& others,
                const Rounding& rounding, double dt) {
  for (const BaselineNumber* one : others) {
    if (one == nullptr || std::isfinite(one->value) != std::isfinite(number.value)) return unbounded;
  }
  if (!std::isfinite(number.value)) return 0;
  const double rounded_by = rounding.of(number.unit);
  // An event between two steps may be noticed a step later.
  const double late = number.unit == "s" ? dt : 0;
  return far_apart * std::sqrt(variance(number.value, others) + rounded_by * rounded_by) + late;
}

void set_bounds(BaselineRun& run, const std::vector<BaselineRun>& perturbed, const Rounding& rounding, double dt) {
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  for (const BaselineRun& other : perturbed) {
    run.perturbed_verdicts.insert(other.verdict);
    // A number that only perturbed runs have may appear on another platform.
    for (const auto& [name, number] : other.numbers) {
      if (run.numbers.count(name) == 0) run.numbers[name] = {.unit = number.unit, .value = missing, .bound = unbounded};
    }
  }
  for (auto& [name, number] : run.numbers) {
    const auto others = numbers_called(name, perturbed);
    if (!number.bound) number.bound = bound_of(number, others, rounding, dt);
    for (const BaselineNumber* one : others) number.unstable |= one != nullptr && one->status != number.status;
  }
}

void find_bounds_of_run(const Case& one_case, const EngineConfig& config, double dt, const CaseTruth& truth,
                        BaselineRun& baseline_run) {
  const Outcome outcome = run(*one_case.scene, config, dt);
  if (!outcome.trace || outcome.status != Status::ok) return;
  const Stepping stepping = config.engine->stepping(config.settings, dt);
  const Rounding rounding(*one_case.scene, *outcome.trace, stepping);
  std::vector<BaselineRun> perturbed_results;
  // A closed form is evaluated, not stepped, so differences do not grow in it.
  if (!config.engine->exact) {
    const double size = perturbation_of(*one_case.scene, stepping);
    for (int seed = 1; seed <= perturbed_runs; ++seed) {
      Case next = one_case;
      next.scene = std::make_shared<const Scene>(perturbed(*one_case.scene, size, static_cast<std::uint64_t>(seed)));
      perturbed_results.push_back(
          baseline_run_of(judged_record(next, config, dt, run_case(next, config, dt), truth.reference())));
    }
  }
  set_bounds(baseline_run, perturbed_results, rounding, dt);
}

}  // namespace

void find_bounds(const Plan& plan, Baseline& baseline, const Progress& progress) {
  struct Job {
    const Case* one_case;
    EngineConfig config;
    BaselineRun* run;
  };
  std::vector<Job> todo;
  for (const Case& one_case : plan.cases) {
    std::vector<EngineConfig> configs = plan.configs;
    if (one_case.closed_form != nullptr) configs.push_back({one_case.closed_form, complete(*one_case.closed_form, {})});
    for (const EngineConfig& config : configs) {
      const auto found =
          baseline.runs.find({one_case.scenario->name, one_case.variant, config.engine->name, config.method()});
      if (found != baseline.runs.end()) todo.push_back({&one_case, config, &found->second});
    }
  }
  CaseTruths truths(plan.dt, plan.refine);
  std::mutex reporting;
  std::size_t done = 0;
  do_all(todo.size(), plan.jobs, [&](std::size_t i) {
    const Job& job = todo[i];
    const Case& one_case = *job.one_case;
    {
      const std::lock_guard alone(reporting);
      progress(fmt::format("{} {}: perturbed runs of {}", one_case.scenario->name, one_case.variant,
                           job.config.engine->name),
               done++, todo.size());
    }
    find_bounds_of_run(one_case, job.config, plan.dt, truths.of(one_case), *job.run);
  });
}

// A number that is rounded n times, each time by u of its size in either direction, has an error of sqrt(n) u of it:
// rounding errors are a random walk (Higham 2002, section 2.8). The error of a velocity acts for the time t. In each
// step a contact turns the rounding of positions into a velocity, by dividing by the step, and over a lever arm into an
// angular velocity.
Rounding::Rounding(const Scene& scene, const Trace& trace, const Stepping& stepping) {
  if (trace.size() < 2) return;
  double speed = 0, turn = 0, spin = 0, impulse = 0, gap = 0;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    for (const BodyState& state : trace.states(i)) {
      largest_ = std::max(largest_, length(state.position));
      speed = std::max(speed, length(state.velocity));
      turn = std::max(turn, std::abs(state.angle));
      spin = std::max(spin, std::abs(state.angular_velocity));
    }
    for (const ContactState& contact : trace.contacts(i)) {
      impulse = std::max(impulse, std::hypot(contact.normal_impulse, contact.tangent_impulse));
      gap = std::max(gap, std::abs(contact.separation));
    }
  }
  double mass = 0, inertia = 0, arm = 1;  // m, the smallest radius of gyration
  for (const Body& body : scene.bodies) {
    const Mass of_body = mass_of(body);
    mass += of_body.mass;
    inertia += of_body.inertia;
    if (of_body.inertia > 0) arm = std::min(arm, std::sqrt(of_body.inertia / of_body.mass));
  }
  h_ = stepping.h > 0 ? stepping.h : trace.time(1) - trace.time(0);
  const double t = trace.times().back();
  // A closed form states no precision; it is evaluated in double.
  const double u = stepping.epsilon > 0 ? stepping.epsilon : std::numeric_limits<double>::epsilon();
  const double share = std::sqrt(t / h_ + 1) * u;
  const double gravity = length(scene.gravity);
  // Bodies at rest get the velocity g h from their weight and lose it again in each step.
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
  if (speed > 0) energy_share_ += 16 * velocity_ / speed;  // a quotient of fourth powers of speeds, about 2
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
