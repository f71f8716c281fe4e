#include "reports/gate/bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "reports/gate/rounding.h"
#include "reports/run/case_run.h"
#include "reports/system/jobs.h"
#include "reports/vec.h"
#include "scenarios/perturbed.h"

namespace plumb {
namespace {

constexpr int neighbours = 16;

// Two draws of one normal distribution, whose deviation s is known from `neighbours` + 1 others, differ by more than
// this many s in one case of a million: sqrt(2) times Student's t with 16 degrees of freedom, at 1 - 5e-7. A hundred
// runs have a few thousand numbers, and another platform shall cry wolf over one in a hundred such reports at most.
const double far_apart = std::sqrt(2.0) * 7.6415;

// m, by which starts differ: eight units of round-off of where a body is, as in horizon.h, but no billionth at least:
// what is told right to round-off stays right.
double smallest_step(const Scene& scene, const Stepping& stepping) {
  double farthest = 1;  // m
  for (const Body& body : scene.bodies) {
    if (body.type == BodyType::dynamic) farthest = std::max(farthest, length(body.position));
  }
  return 8 * stepping.epsilon * farthest;
}

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

double variance(double value, const std::vector<const KeptNumber*>& others) {
  if (others.empty()) return 0;
  double sum = value;
  for (const KeptNumber* one : others) sum += one->value;
  const double mean = sum / static_cast<double>(others.size() + 1);
  double squares = (value - mean) * (value - mean);
  for (const KeptNumber* one : others) squares += (one->value - mean) * (one->value - mean);
  return squares / static_cast<double>(others.size());
}

// The number in every run next to this one; null where that does not have it.
std::vector<const KeptNumber*> same_in(const std::vector<KeptRun>& others, const std::string& name) {
  std::vector<const KeptNumber*> all;
  for (const KeptRun& other : others) {
    const auto found = other.numbers.find(name);
    all.push_back(found == other.numbers.end() ? nullptr : &found->second);
  }
  return all;
}

double may_move(const KeptNumber& number, const std::vector<const KeptNumber*>& others, const Rounding& rounding,
                double dt) {
  for (const KeptNumber* one : others) {
    if (one == nullptr || std::isfinite(one->value) != std::isfinite(number.value)) return infinity;
  }
  if (!std::isfinite(number.value)) return 0;
  const double rounded = rounding.of(number.unit);
  // What falls between two steps may fall into the next.
  const double late = number.unit == "s" ? dt : 0;
  return far_apart * std::sqrt(variance(number.value, others) + rounded * rounded) + late;
}

void set_bounds(KeptRun& run, const std::vector<KeptRun>& others, const Rounding& rounding, double dt) {
  for (const KeptRun& other : others) {
    run.neighbours.insert(other.verdict);
    // What only they have stands for what may come.
    for (const auto& [name, number] : other.numbers) {
      if (run.numbers.count(name) == 0) run.numbers[name] = {.unit = number.unit, .value = missing, .moves = infinity};
    }
  }
  for (auto& [name, number] : run.numbers) {
    const auto same = same_in(others, name);
    if (!number.moves) number.moves = may_move(number, same, rounding, dt);
    for (const KeptNumber* one : same) number.wavers |= one != nullptr && one->status != number.status;
  }
}

// A truth and its trace, for as long as this lives.
class Witnessed {
 public:
  Witnessed(const Case& asked, double dt) {
    if (asked.closed_form == nullptr) return;
    const EngineConfig closed_form{asked.closed_form, complete(*asked.closed_form, {})};
    const Outcome outcome = run(*asked.scene, closed_form, dt);
    if (outcome.status != Status::ok) return;
    truth_.emplace(*asked.closed_form, *asked.scene);
    known_ = {&*truth_, outcome.trace};
  }
  Witnessed(const Witnessed&) = delete;
  Witnessed& operator=(const Witnessed&) = delete;
  ~Witnessed() = default;
  const ReferenceRun& known() const { return known_; }

 private:
  std::optional<Truth> truth_;
  ReferenceRun known_;
};

void find_bounds(const Case& asked, const EngineConfig& config, double dt, KeptRun& kept_run) {
  const Outcome itself = run(*asked.scene, config, dt);
  if (!itself.trace || itself.status != Status::ok) return;
  const Stepping stepping = config.engine->stepping(config.settings, dt);
  const Rounding rounding(*asked.scene, *itself.trace, stepping);
  std::vector<KeptRun> others;
  // A closed form is evaluated, not stepped: nothing grows in it.
  if (!config.engine->exact) {
    const Witnessed witnessed(asked, dt);
    const double size = smallest_step(*asked.scene, stepping);
    for (int seed = 1; seed <= neighbours; ++seed) {
      Case next = asked;
      next.scene = std::make_shared<const Scene>(perturbed(*asked.scene, size, static_cast<std::uint64_t>(seed)));
      others.push_back(kept(judged_record(next, config, dt, run_case(next, config, dt), witnessed.known())));
    }
  }
  set_bounds(kept_run, others, rounding, dt);
}

}  // namespace

void find_bounds(const Plan& plan, Baseline& baseline, const Progress& progress) {
  struct Job {
    const Case* asked;
    EngineConfig config;
    KeptRun* run;
  };
  std::vector<Job> todo;
  for (const Case& asked : plan.cases) {
    std::vector<EngineConfig> configs = plan.configs;
    if (asked.closed_form != nullptr) configs.push_back({asked.closed_form, complete(*asked.closed_form, {})});
    for (const EngineConfig& config : configs) {
      const auto found =
          baseline.runs.find({asked.scenario->name, asked.variant, config.engine->name, config.method()});
      if (found != baseline.runs.end()) todo.push_back({&asked, config, &found->second});
    }
  }
  std::mutex telling;
  std::size_t done = 0;
  do_all(todo.size(), plan.jobs, [&](std::size_t i) {
    const Job& job = todo[i];
    {
      const std::lock_guard alone(telling);
      progress(fmt::format("{} {}: starts next to that of {}", job.asked->scenario->name, job.asked->variant,
                           job.config.engine->name),
               done++, todo.size());
    }
    find_bounds(*job.asked, job.config, plan.dt, *job.run);
  });
}

}  // namespace plumb
