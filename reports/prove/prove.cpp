#include "reports/prove/prove.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <set>

#include "reports/prove/variation.h"
#include "reports/run/selection.h"
#include "reports/system/jobs.h"

namespace plumb {
namespace {

// Body-steps; about a tenth of a second of our engine.
constexpr double largest = 40000;

double size_of(const Case& one, double dt) {
  return static_cast<double>(one.scene->bodies.size() * steps_in(one.scene->duration, dt));
}

bool tells(const Alarm& alarm) { return alarm.means != Means::bits; }

std::string label_of(const Case& one) { return one.scenario->name + " " + one.variant; }

/// Counts pieces of work as they begin, in any thread.
class Counter {
 public:
  Counter(const ProveProgress& progress, std::size_t all) : progress_(progress), all_(all) {}
  void begin(const std::string& what) {
    const std::lock_guard alone(telling_);
    progress_(what, done_++, all_);
  }

 private:
  const ProveProgress& progress_;
  std::size_t all_, done_ = 0;
  std::mutex telling_;
};

/// The right methods, each examined once in every case.
class RightOnes {
 public:
  explicit RightOnes(const std::vector<Fault>& faults) {
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
  // One that is held against something of its own has it to itself.
  static std::string key_of(const Fault& fault) {
    std::string key = fault.right == nullptr ? "" : fault.name;
    for (const auto& [option, value] : fault.method) key += "," + option + "=" + value;
    return key;
  }
  std::map<std::string, std::size_t> number_;
  std::vector<Engine> engines_;
  std::vector<Settings> settings_;
};

}  // namespace

std::vector<Case> cases_to_prove_by(double dt) {
  std::vector<Case> cases = default_cases(true);
  std::erase_if(cases, [dt](const Case& one) { return size_of(one, dt) > largest; });
  std::stable_partition(cases.begin(), cases.end(), [](const Case& one) { return one.scenario->canonical; });
  return cases;
}

bool Proof::caught() const { return std::any_of(alarms.begin(), alarms.end(), tells); }

bool Proof::caught_by_physics() const {
  return std::any_of(alarms.begin(), alarms.end(),
                     [](const Alarm& alarm) { return alarm.means == Means::truth || alarm.means == Means::invariant; });
}

const Alarm* Proof::best() const {
  const Alarm* best = nullptr;
  for (const Alarm& alarm : alarms) {
    if (!tells(alarm)) continue;
    if (best == nullptr || alarm.ratio > best->ratio) best = &alarm;
  }
  return best;
}

std::vector<std::string> Proof::scenarios() const {
  std::vector<std::string> names;
  for (const Alarm& alarm : alarms) {
    if (tells(alarm) && std::find(names.begin(), names.end(), alarm.scenario) == names.end()) {
      names.push_back(alarm.scenario);
    }
  }
  return names;
}

std::vector<Proof> prove(const std::vector<Fault>& faults, const std::vector<Case>& cases, double dt, int jobs,
                         const ProveProgress& progress) {
  const RightOnes right(faults);
  Counter counter(progress, (right.size() + faults.size()) * cases.size());
  std::vector<Examined> known(right.size() * cases.size());
  do_all(known.size(), jobs, [&](std::size_t i) {
    const Case& asked = cases[i % cases.size()];
    counter.begin(label_of(asked));
    known[i] = examine_twice(asked, right.config(i / cases.size()), dt);
  });

  std::vector<Engine> faulty;
  for (const Fault& fault : faults) faulty.push_back(faulty_engine(fault));
  std::vector<std::vector<Alarm>> found(faults.size() * cases.size());
  do_all(found.size(), jobs, [&](std::size_t i) {
    const std::size_t f = i / cases.size();
    const std::size_t c = i % cases.size();
    counter.begin(faults[f].name + ": " + label_of(cases[c]));
    const Examined& by_right = known[right.number_of(faults[f]) * cases.size() + c];
    if (by_right.status != Status::ok) return;
    found[i] = alarms(cases[c], by_right, examine_twice(cases[c], {&faulty[f], settings_of(faults[f])}, dt));
  });

  std::vector<Proof> proofs;
  for (std::size_t f = 0; f < faults.size(); ++f) {
    proofs.push_back({faults[f], {}});
    for (std::size_t c = 0; c < cases.size(); ++c) {
      for (Alarm& alarm : found[f * cases.size() + c]) proofs.back().alarms.push_back(std::move(alarm));
    }
  }
  return proofs;
}

std::vector<std::string> fewest_scenarios(const std::vector<Proof>& proofs) {
  std::map<std::string, std::set<std::string>> catches;
  std::set<std::string> left;
  for (const Proof& proof : proofs) {
    for (const std::string& scenario : proof.scenarios()) {
      catches[scenario].insert(proof.fault.name);
      left.insert(proof.fault.name);
    }
  }
  std::vector<std::string> chosen;
  while (!left.empty()) {
    const auto caught_by = [&](const auto& one) {
      return std::count_if(one.second.begin(), one.second.end(),
                           [&](const auto& name) { return left.count(name) > 0; });
    };
    const auto most = std::max_element(catches.begin(), catches.end(),
                                       [&](const auto& a, const auto& b) { return caught_by(a) < caught_by(b); });
    chosen.push_back(most->first);
    for (const std::string& name : most->second) left.erase(name);
  }
  return chosen;
}

std::vector<CleanRun> clean_runs(int count, const std::vector<Case>& cases, double dt, int jobs,
                                 const ProveProgress& progress) {
  const Engine& ours = *Catalog<Engine>::find("impulse");
  const EngineConfig usual{&ours, complete(ours, {})};
  const auto runs = static_cast<std::size_t>(count);
  Counter counter(progress, (runs + 1) * cases.size());
  std::vector<Examined> known(cases.size());
  if (runs > 0) {
    do_all(cases.size(), jobs, [&](std::size_t c) {
      counter.begin(label_of(cases[c]));
      known[c] = examine_twice(cases[c], usual, dt);
    });
  }
  std::vector<std::vector<Alarm>> found(runs * cases.size());
  do_all(found.size(), jobs, [&](std::size_t i) {
    const std::size_t c = i % cases.size();
    const Variation variation = variation_of(i / cases.size() + 1);
    counter.begin(variation.words() + ": " + label_of(cases[c]));
    const Case varied = variation.of(cases[c]);
    const Examined right = varied.scene == cases[c].scene ? known[c] : examine_twice(varied, usual, dt);
    found[i] = physics_alarms(varied, right, examine_twice(varied, {&ours, complete(ours, variation.settings)}, dt));
  });
  std::vector<CleanRun> clean;
  for (std::size_t r = 0; r < runs; ++r) {
    clean.push_back({r + 1, variation_of(r + 1).words(), {}});
    for (std::size_t c = 0; c < cases.size(); ++c) {
      for (Alarm& alarm : found[r * cases.size() + c]) clean.back().alarms.push_back(std::move(alarm));
    }
  }
  return clean;
}

}  // namespace plumb
