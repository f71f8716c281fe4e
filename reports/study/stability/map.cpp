#include "reports/study/stability/map.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "reports/study/study.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json axis_json(const Axis& axis) {
  return {{"name", axis.name},
          {"unit", axis.unit},
          {"from", axis.from},
          {"to", axis.to},
          {"logarithmic", axis.logarithmic},
          {"whole", axis.whole}};
}

}  // namespace

std::vector<double> Axis::values(int n) const {
  std::vector<double> all;
  for (int i = 0; i < n; ++i) {
    const double share = n > 1 ? static_cast<double>(i) / (n - 1) : 0;
    // The ends are exact, without rounding.
    const double value = share == 0    ? from
                         : share == 1  ? to
                         : logarithmic ? from * std::pow(to / from, share)
                                       : from + (to - from) * share;
    const double rounded = whole ? std::round(value) : value;
    if (all.empty() || all.back() != rounded) all.push_back(rounded);
  }
  return all;
}

double Axis::between(double a, double b) const {
  const double middle = logarithmic ? std::sqrt(a * b) : (a + b) / 2;
  if (!whole) return middle;
  const double rounded = std::round(middle);
  return rounded == b ? a : rounded;
}

bool Boundary::fails(FailureMode mode) const {
  if (failing.empty() || mode == FailureMode::diverges || mode == FailureMode::fails) return is_failure(mode);
  return std::find(failing.begin(), failing.end(), mode) != failing.end();
}

TrialOutcome run_trial(const Trial& trial, const EngineConfig& config) {
  TrialOutcome found;
  const double end = trial.scene->duration - trial.dt / 2;
  const auto name = [&](std::optional<std::size_t> body) { return body ? trial.scene->bodies[*body].name : ""; };
  const Outcome outcome =
      watch(*trial.scene, config, trial.dt, trial.first_step, [&](double time, std::span<const BodyState> states) {
        found.time = time;
        const ObservedStep step{time, states, time > end};
        for (const Detector& detector : trial.detectors) {
          const std::optional<DetectorFinding> finding = detector.check(step);
          if (!finding) continue;
          found.mode = finding->mode;
          found.body = name(finding->body);
          return false;
        }
        return true;
      });
  if (outcome.status == Status::ok) return found;
  const FailureMode mode = outcome.status == Status::not_supported ? FailureMode::not_supported
                           : outcome.lost                          ? FailureMode::diverges
                                                                   : FailureMode::fails;
  return {mode, outcome.time, name(outcome.lost), outcome.reason};
}

Scene catalog_scene(const char* scenario, const Parameters& changes) {
  const Scenario* found = Catalog<Scenario>::find(scenario);
  if (found == nullptr) throw std::logic_error(std::string("there is no scenario \"") + scenario + "\"");
  return found->scene(complete(*found, changes));
}

double stated_gap(const EngineConfig& config, double dt) {
  std::string why_not;
  const auto stated = stepping_of(config, dt, why_not);
  return stated ? stated->contact_gap() : 0;  // without it the trial fails
}

Json description_of(const StabilityMap& map, int cells) {
  // Criteria differ between cells and methods only in their numbers: these are the default method's.
  const Method first = default_methods().front();
  Json criteria = Json::array();
  const std::vector<Trial> trials = map.trials(map.x.from, map.typical, first.config);
  for (const Detector& detector : trials.front().detectors) criteria.push_back(detector.criterion);
  Json boundaries = Json::array();
  for (const Boundary& boundary : map.boundaries) {
    Json failing = Json::array();
    for (const FailureMode mode : boundary.failing) failing.push_back(name_of(mode));
    boundaries.push_back({{"name", boundary.name},
                          {"failing", failing},
                          {"resolution", boundary.resolution},
                          {"source", boundary.source},
                          {"agreement", boundary.agreement},
                          {"natural", boundary.natural}});
  }
  Json described{{"name", map.name},        {"question", map.question},
                 {"x", axis_json(map.x)},   {"y", map.y ? axis_json(*map.y) : Json(nullptr)},
                 {"typical", map.typical},  {"metrics", criteria},
                 {"boundaries", boundaries}};
  described["x"]["values"] = map.x.values(cells);
  return described;
}

}  // namespace plumb
