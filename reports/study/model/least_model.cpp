#include "reports/study/model/least_model.h"

#include <algorithm>

#include "reports/report.h"
#include "reports/run/timings.h"
#include "reports/statistics.h"
#include "reports/study/job.h"
#include "reports/study/model/model_error.h"
#include "reports/system/clock.h"
#include "reports/timing/repetitions.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

struct DropCandidate {
  FeatureDrop drop;
  double ratio;  // cost with only this drop, relative to the full model
};

FeatureLevels with(FeatureLevels levels, const FeatureDrop& drop) {
  levels[drop.feature] = drop.step;
  return levels;
}

std::vector<DropCandidate> by_saving(const std::vector<FeatureDrop>& drops, const FeatureLevels& full,
                                     const ModelTrials& trials) {
  std::vector<DropCandidate> candidates;
  for (const FeatureDrop& drop : drops) {
    if (trials.out_of_time()) break;
    const FeatureLevels alone = with(full, drop);
    if (!trials.slow_to_judge && !trials.sufficient(alone)) continue;
    const double ratio = trials.cost_ratio(alone, full);
    if (!trials.slow_to_judge || ratio < 1) candidates.push_back({drop, ratio});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.ratio < b.ratio; });
  return candidates;
}

// s per simulated second: the least of up to three runs, as other work on the machine only adds to it.
double undisturbed_cost(const ModelError& errors, const EngineConfig& model) {
  constexpr double slow = 0.01;  // s; in longer runs interruptions average out
  const Scene& scene = *errors.problem().scene;
  double least = step_cost(scene, model, errors.dt());
  for (int i = 0; i < 2 && least * scene.duration < slow; ++i)
    least = std::min(least, step_cost(scene, model, errors.dt()));
  return least;
}

// Quartiles of a's cost over b's. The two alternate in who runs first; repetitions end once `decided` says so.
Quartiles cost_ratio(const ModelError& errors, const EngineConfig& a, const EngineConfig& b, std::size_t fewest,
                     const std::function<bool(const Quartiles&)>& decided) {
  constexpr std::size_t most = 15;
  return time_ratio([&] { return undisturbed_cost(errors, a); }, [&] { return undisturbed_cost(errors, b); }, fewest,
                    most, decided);
}

// Fraction of the cost that a drop must save, in three of four repetitions, to be worth it.
constexpr double worth = 0.03;

bool clearly_above_or_below(const Quartiles& ratio) { return ratio.high < 1 - worth || ratio.low > 1 - worth; }
// Of the time of a job, for the search; the rest is for what it cannot interrupt, and for measuring what it has found.
constexpr double search_share = 0.4;

class Budget {
 public:
  explicit Budget(double seconds) : seconds_(seconds) {}
  bool past(double share) const { return spent_.seconds() > share * seconds_; }

 private:
  Stopwatch spent_;
  double seconds_;
};

bool steady(const Quartiles& ratio) { return ratio.high - ratio.low < worth * ratio.median; }

Json json_of(const Quartiles& of) { return {{"median", of.median}, {"low", of.low}, {"high", of.high}}; }

}  // namespace

const std::vector<Feature>& model_features() {
  static const std::vector<Feature> features{
      {"contacts", {{"any contact", {{"contacts", "off"}}}}},
      {"method",
       {{"impacts at their own times, loads without sinking", {{"solver", "soft-step"}}},
        {"those, and contacts in sub-steps", {{"solver", "sequential-impulse"}, {"integrator", "velocity-verlet"}}},
        {"those, and position correction",
         {{"solver", "split-impulse"}, {"integrator", "velocity-verlet"}, {"position-iterations", "0"}}},
        {"sub-steps and warm starting", {{"solver", "article"}, {"integrator", "velocity-verlet"}}},
        {"those, and second order in flight", {{"solver", "article"}, {"integrator", "symplectic-euler"}}}}},
      {"sub-steps", {{"half of them", {{"substeps", "2"}}}, {"any", {{"substeps", "1"}}}}},
      {"iterations", {{"most", {{"iterations", "4"}}}, {"all but one", {{"iterations", "1"}}}}},
      {"restitution", {{"any rebound", {{"restitution", "off"}}}}},
      {"friction",
       {{"the higher friction while sticking", {{"friction", "dynamic"}}}, {"any friction", {{"friction", "off"}}}}},
      {"rotation", {{"any rotation", {{"rotation", "off"}}}}},
      {"continuous collision", {{"it", {{"continuous", "off"}}}}},
      {"broad phase",
       {{"any: all pairs", {{"broad-phase", "brute"}}},
        {"a choice: a grid", {{"broad-phase", "grid"}}},
        {"a choice: a tree", {{"broad-phase", "tree"}}}}},
      {"wakefulness", {{"solving bodies at rest", {{"sleeping", "on"}}}}},
      {"double precision", {{"it", {{"precision", "float"}}}}},
  };
  return features;
}

EngineConfig model_at(const EngineConfig& full, const FeatureLevels& levels) {
  const std::vector<Feature>& features = model_features();
  EngineConfig model = full;
  for (std::size_t f = 0; f < features.size(); ++f) {
    if (levels[f] == 0) continue;
    for (const auto& [key, value] : features[f].steps[levels[f] - 1].change) model.settings[key] = value;
  }
  model.settings = complete(*full.engine, model.settings);
  return model;
}

std::vector<FeatureDrop> single_drops(const EngineConfig& full) {
  const std::vector<Feature>& features = model_features();
  std::vector<FeatureDrop> drops;
  for (std::size_t f = 0; f < features.size(); ++f) {
    for (std::size_t step = 1; step <= features[f].steps.size(); ++step) {
      FeatureLevels levels(features.size(), 0);
      levels[f] = step;
      if (model_at(full, levels).settings == full.settings) continue;
      std::string setting;
      for (const auto& [key, value] : features[f].steps[step - 1].change)
        setting += (setting.empty() ? "" : ",") + key + "=" + value;
      drops.push_back({f, step, setting});
    }
  }
  return drops;
}

EngineConfig automatic_model(const EngineConfig& full) {
  EngineConfig automatic = full;
  automatic.settings["model"] = "auto";
  return automatic;
}

FeatureLevels least_model(const std::vector<FeatureDrop>& drops, std::size_t features, const ModelTrials& trials) {
  FeatureLevels least(features, 0);
  const std::vector<DropCandidate> candidates = by_saving(drops, least, trials);
  for (const DropCandidate& candidate : candidates) {
    if (trials.out_of_time()) return least;
    if (least[candidate.drop.feature] != 0) continue;
    // Only drops that are sufficient by themselves: no other drop is known to make up for one that is not.
    const FeatureLevels alone = with(FeatureLevels(features, 0), candidate.drop);
    const FeatureLevels lower = with(least, candidate.drop);
    if (trials.slow_to_judge && lower != alone && !trials.sufficient(alone)) continue;
    if (trials.sufficient(lower) && trials.cheaper(lower, least)) least = lower;
  }
  for (std::size_t f = 0; f < features; ++f) {
    if (trials.out_of_time()) return least;
    if (least[f] == 0) continue;
    FeatureLevels restored = least;
    restored[f] = 0;
    if (trials.sufficient(restored) && !trials.cheaper(least, restored)) least = restored;
  }
  return least;
}

JobOutput search_least_model(const ModelError& errors, double seconds) {
  const Budget budget(seconds);
  const EngineConfig& full = errors.full();
  const Case& problem = errors.problem();
  JobOutput output;
  output.values = {{"scenario", problem.scenario->name}, {"variant", problem.variant}, {"role", "least"}};
  if (!errors.within_tolerance(errors.of(full))) {
    output.values["why"] = "the full model itself does not run to the end";
    return output;
  }
  const auto enough = [&](const auto& decided) {
    return [&budget, decided](const Quartiles& ratio) { return decided(ratio) || budget.past(search_share); };
  };
  const auto compare = [&](const FeatureLevels& a, const FeatureLevels& b, std::size_t fewest) {
    return cost_ratio(errors, model_at(full, a), model_at(full, b), fewest, enough(clearly_above_or_below));
  };
  constexpr std::size_t fewest = 4;
  bool complete = true;
  const ModelTrials trials{
      .sufficient =
          [&](const FeatureLevels& levels) { return errors.within_tolerance(errors.of(model_at(full, levels))); },
      .cost_ratio = [&](const FeatureLevels& a, const FeatureLevels& b) { return compare(a, b, 1).median; },
      .cheaper = [&](const FeatureLevels& a, const FeatureLevels& b) { return compare(a, b, fewest).high < 1 - worth; },
      .slow_to_judge = errors.chaotic(),
      .out_of_time =
          [&] {
            if (budget.past(search_share)) complete = false;
            return !complete;
          }};
  FeatureLevels least = least_model(single_drops(full), model_features().size(), trials);
  const std::size_t last = complete ? fewest : 2;
  Quartiles cheaper = cost_ratio(errors, full, model_at(full, least), last, enough(steady));
  // What seemed to save time in the search was noise.
  if (!(cheaper.median > 1)) {
    std::fill(least.begin(), least.end(), 0);
    cheaper = {1, 1, 1};
  }
  const EngineConfig model = model_at(full, least);
  const ModelError::Result result = errors.of(model);
  output.values["complete"] = complete;
  output.times = {{"line", label_of(model.engine->name, model.method())},
                  {"error", finite_or_null(result.error)},
                  {"change", finite_or_null(result.change)},
                  {"cheaper", json_of(cheaper)},
                  {"auto_cheaper", json_of(cost_ratio(errors, full, automatic_model(full), last, enough(steady)))}};
  Json dropped = Json::array();
  for (std::size_t f = 0; f < least.size(); ++f) {
    if (least[f] == 0) continue;
    const Feature& feature = model_features()[f];
    dropped.push_back({{"feature", feature.name}, {"without", feature.steps[least[f] - 1].without}});
  }
  output.times["dropped"] = std::move(dropped);
  return output;
}

}  // namespace plumb
