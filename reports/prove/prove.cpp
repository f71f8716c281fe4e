#include "reports/prove/prove.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>

#include "reports/run/experiment.h"
#include "reports/run/selection.h"
#include "reports/system/jobs.h"
#include "scenarios/random.h"

namespace plumb {
namespace {

// Bodies times steps; about a twentieth of a second of our engine, and of one with a fault up to a minute.
constexpr double largest_case = 20000;

double size_of(const Case& one, double dt) {
  return static_cast<double>(one.scene->bodies.size() * steps_in(one.scene->duration, dt));
}

bool catches(const Detection& detection) { return detection.kind != DetectionKind::bits; }

// The right engines of some faults, each once.
class RightEngines {
 public:
  explicit RightEngines(const std::vector<Fault>& faults) {
    for (const Fault& fault : faults) {
      if (number_.emplace(key_of(fault), engines_.size()).second) {
        engines_.push_back(right_engine(fault));
        settings_.push_back(settings_of(fault));
      }
    }
  }
  std::size_t size() const { return engines_.size(); }
  EngineConfig config(std::size_t i) const { return {&engines_[i], settings_[i]}; }
  std::size_t number_of(const Fault& fault) const { return number_.at(key_of(fault)); }

 private:
  // Faults of the same method share an engine, unless a fault brings its own.
  static std::string key_of(const Fault& fault) {
    std::string key = fault.right == nullptr ? "" : fault.name;
    for (const auto& [option, value] : fault.method) key.append(",").append(option).append("=").append(value);
    return key;
  }
  std::map<std::string, std::size_t> number_;
  std::vector<Engine> engines_;
  std::vector<Settings> settings_;
};

std::vector<CleanRun> runs_of(const std::vector<Variation>& variations, const std::vector<Case>& cases,
                              CaseTruths& truths, int jobs, const Progress& progress) {
  const Engine& ours = *Catalog<Engine>::find("impulse");
  struct Found {
    std::vector<Detection> alarms;
    std::vector<LooseTruth> loose;
  };
  std::vector<Found> found(variations.size() * cases.size());
  ProgressCounter counter(progress, found.size());
  do_all(found.size(), jobs, [&](std::size_t i) {
    const Variation& variation = variations[i / cases.size()];
    const Case one_case = variation.of(cases[i % cases.size()]);
    counter.begin(variation.text() + ": " + label_of(one_case));
    const EngineConfig config{&ours, complete(ours, variation.settings)};
    const JudgedRun judged = judge_two_runs(one_case, config, truths.dt(), truths.of(one_case));
    found[i].alarms = false_alarms(one_case, judged);
    if (variation.seed == 0) found[i].loose = loose_truths(one_case, judged);
  });
  std::vector<CleanRun> runs;
  for (std::size_t r = 0; r < variations.size(); ++r) {
    runs.push_back({variations[r].seed, variations[r].text(), {}});
    for (std::size_t c = 0; c < cases.size(); ++c) {
      Found& of_case = found[r * cases.size() + c];
      std::ranges::move(of_case.alarms, std::back_inserter(runs.back().false_alarms));
      std::ranges::move(of_case.loose, std::back_inserter(runs.back().loose));
    }
  }
  return runs;
}

}  // namespace

std::vector<Case> cases_to_prove_by(std::vector<Case> cases, double dt) {
  std::erase_if(cases, [dt](const Case& one) { return size_of(one, dt) > largest_case; });
  std::stable_partition(cases.begin(), cases.end(), [](const Case& one) { return one.scenario->canonical; });
  return cases;
}

bool FaultResult::caught() const { return std::any_of(detections.begin(), detections.end(), catches); }

bool FaultResult::caught_by_physics() const {
  return std::any_of(detections.begin(), detections.end(), [](const Detection& one) {
    return one.kind == DetectionKind::truth || one.kind == DetectionKind::invariant;
  });
}

const Detection* FaultResult::best() const {
  const Detection* best = nullptr;
  for (const Detection& one : detections) {
    if (!catches(one)) continue;
    if (best == nullptr || one.ratio > best->ratio) best = &one;
  }
  return best;
}

std::vector<std::string> FaultResult::scenarios() const {
  std::vector<std::string> names;
  for (const Detection& one : detections) {
    if (catches(one) && std::find(names.begin(), names.end(), one.scenario) == names.end()) {
      names.push_back(one.scenario);
    }
  }
  return names;
}

std::vector<FaultResult> prove(const std::vector<Fault>& faults, const std::vector<Case>& cases, CaseTruths& truths,
                               int jobs, const Progress& progress) {
  const RightEngines right(faults);
  ProgressCounter counter(progress, (right.size() + faults.size()) * cases.size());
  std::vector<JudgedRun> right_runs(right.size() * cases.size());
  do_all(right_runs.size(), jobs, [&](std::size_t i) {
    const Case& one_case = cases[i % cases.size()];
    counter.begin(label_of(one_case));
    right_runs[i] = judge_two_runs(one_case, right.config(i / cases.size()), truths.dt(), truths.of(one_case));
  });

  std::vector<Engine> faulty;
  faulty.reserve(faults.size());
  for (const Fault& fault : faults) faulty.push_back(faulty_engine(fault));
  std::vector<std::vector<Detection>> found(faults.size() * cases.size());
  do_all(found.size(), jobs, [&](std::size_t i) {
    const std::size_t f = i / cases.size();
    const std::size_t c = i % cases.size();
    counter.begin(faults[f].name + ": " + label_of(cases[c]));
    const JudgedRun& right_run = right_runs[right.number_of(faults[f]) * cases.size() + c];
    if (right_run.status != Status::ok) return;
    const EngineConfig config{&faulty[f], settings_of(faults[f])};
    found[i] = detections(cases[c], right_run, judge_two_runs(cases[c], config, truths.dt(), truths.of(cases[c])));
  });

  std::vector<FaultResult> results;
  for (std::size_t f = 0; f < faults.size(); ++f) {
    results.push_back({faults[f], {}});
    for (std::size_t c = 0; c < cases.size(); ++c) {
      for (Detection& one : found[f * cases.size() + c]) results.back().detections.push_back(std::move(one));
    }
  }
  return results;
}

std::vector<std::string> fewest_scenarios(const std::vector<FaultResult>& results) {
  std::map<std::string, std::set<std::string>> caught;  // faults, by scenario
  std::set<std::string> remaining;
  for (const FaultResult& result : results) {
    for (const std::string& scenario : result.scenarios()) {
      caught[scenario].insert(result.fault.name);
      remaining.insert(result.fault.name);
    }
  }
  std::vector<std::string> chosen;
  while (!remaining.empty()) {
    const auto count = [&](const auto& one) {
      return std::count_if(one.second.begin(), one.second.end(),
                           [&](const auto& name) { return remaining.count(name) > 0; });
    };
    const auto most = std::max_element(caught.begin(), caught.end(),
                                       [&](const auto& a, const auto& b) { return count(a) < count(b); });
    chosen.push_back(most->first);
    for (const std::string& name : most->second) remaining.erase(name);
  }
  return chosen;
}

Variation variation_of(std::uint64_t seed) {
  Random random(seed);
  const auto one_of = [&](const auto& choices) { return choices[random.next() % choices.size()]; };
  constexpr std::array precisions{"float", "double"};
  constexpr std::array broad_phases{"auto", "brute", "grid", "tree"};
  constexpr std::array workers{"1", "2", "3", "4"};
  constexpr std::array lanes{"accurate", "accurate-scalar"};
  return {.seed = seed,
          .settings = {{"precision", one_of(precisions)},
                       {"broad-phase", one_of(broad_phases)},
                       {"workers", one_of(workers)},
                       {"solver", one_of(lanes)}}};
}

Case Variation::of(const Case& one_case) const {
  if (seed == 0) return one_case;
  const auto& parameters = one_case.scenario->parameters;
  const auto random = std::find_if(parameters.begin(), parameters.end(),
                                   [](const Parameter& parameter) { return parameter.name == "seed"; });
  if (random == parameters.end()) return one_case;
  Case varied = one_case;
  varied.parameters.at("seed") = std::min(random->min + static_cast<double>(seed), random->max);
  varied.scene = std::make_shared<const Scene>(one_case.scenario->scene(varied.parameters));
  return varied;
}

std::string Variation::text() const {
  if (seed == 0) return "default settings";
  std::string text = "seed " + std::to_string(seed) + ":";
  for (const auto& [option, value] : settings) {
    text.append(text.back() == ':' ? " " : ", ").append(option).append("=").append(value);
  }
  return text;
}

CleanRun default_run(const std::vector<Case>& cases, CaseTruths& truths, int jobs, const Progress& progress) {
  return runs_of({Variation{}}, cases, truths, jobs, progress).front();
}

std::vector<CleanRun> clean_runs(int count, const std::vector<Case>& cases, CaseTruths& truths, int jobs,
                                 const Progress& progress) {
  std::vector<Variation> variations;
  for (int seed = 1; seed <= count; ++seed) variations.push_back(variation_of(static_cast<std::uint64_t>(seed)));
  return runs_of(variations, cases, truths, jobs, progress);
}

}  // namespace plumb
