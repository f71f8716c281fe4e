#include "reports/prove/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <utility>

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

std::string method_of(const Fault& fault) {
  std::string text;
  for (const auto& [option, value] : fault.method) text += (text.empty() ? "" : ",") + value;
  return text.empty() ? "accurate" : text;
}

std::string case_of(const Detection& one) { return one.scenario + (one.variant.empty() ? "" : " " + one.variant); }

std::string line_of(const FaultResult& result) {
  const Detection* best = result.best();
  if (best == nullptr) {
    return fmt::format("{:<30}{:<26}{}\n", result.fault.name, method_of(result.fault),
                       result.detections.empty() ? "NOT SEEN: the same bits everywhere" : "NOT SEEN: only bits differ");
  }
  return fmt::format("{:<30}{:<26}{:<28}{:<20.20}{:<10}{:>18}{:>10}\n", result.fault.name, method_of(result.fault),
                     case_of(*best), best->metric, name_of(best->kind), ratio_text(best->ratio),
                     result.scenarios().size());
}

Json json_of(const std::vector<Detection>& all) {
  Json list = Json::array();
  for (const Detection& one : all) list.push_back(to_json(one));
  return list;
}

// Several phases or bodies of a run may fail the same check.
struct Alarm {
  const Detection* worst = nullptr;
  const CleanRun* worst_run = nullptr;
  std::set<const CleanRun*> runs;
};

std::string false_alarms_text(const ProveReport& report) {
  std::map<std::pair<std::string, std::string>, Alarm> alarms;  // by case and check
  for (const CleanRun& run : report.clean) {
    for (const Detection& one : run.false_alarms) {
      Alarm& alarm = alarms[{case_of(one), one.metric}];
      alarm.runs.insert(&run);
      if (alarm.worst != nullptr && one.ratio <= alarm.worst->ratio) continue;
      alarm.worst = &one;
      alarm.worst_run = &run;
    }
  }
  std::string text;
  for (const auto& [check, alarm] : alarms) {
    const Detection& worst = *alarm.worst;
    text += fmt::format("FALSE ALARM in {}, {}: {:.3g}{} where {:.3g} is allowed ({}), with {}", check.first,
                        check.second, worst.error, worst.unit.empty() ? "" : " " + worst.unit, worst.tolerance,
                        ratio_text(worst.ratio), alarm.worst_run->settings);
    text += alarm.runs.size() > 1 ? fmt::format("; in {} clean runs\n", alarm.runs.size()) : "\n";
  }
  return text;
}

std::string loose_truths_text(const ProveReport& report) {
  std::string text;
  for (const CleanRun& run : report.clean) {
    for (const LooseTruth& one : run.loose) {
      text += fmt::format("NOT A TEST in {} {}, {}: {:.2g} of its scale is allowed, more than {:g} %\n", one.scenario,
                          one.variant, one.check.what, one.check.share, 100 * evidence_share);
    }
  }
  return text;
}

}  // namespace

std::size_t ProveReport::caught() const {
  return static_cast<std::size_t>(
      std::count_if(faults.begin(), faults.end(), [](const FaultResult& result) { return result.caught(); }));
}

std::size_t ProveReport::caught_by_physics() const {
  return static_cast<std::size_t>(std::count_if(faults.begin(), faults.end(),
                                                [](const FaultResult& result) { return result.caught_by_physics(); }));
}

std::size_t ProveReport::runs_with_false_alarms() const {
  return static_cast<std::size_t>(
      std::count_if(clean.begin(), clean.end(), [](const CleanRun& run) { return !run.false_alarms.empty(); }));
}

std::size_t ProveReport::loose_truths() const {
  return std::accumulate(clean.begin(), clean.end(), std::size_t{0},
                         [](std::size_t sum, const CleanRun& run) { return sum + run.loose.size(); });
}

bool ProveReport::passed() const {
  return caught() == faults.size() && runs_with_false_alarms() == 0 && loose_truths() == 0;
}

std::string text_of(const ProveReport& report) {
  std::string text = fmt::format(
      "{} of {} faults caught, {} of them by truth or invariant; false alarms in {} of {} clean runs; cases: {}.\n\n",
      report.caught(), report.faults.size(), report.caught_by_physics(), report.runs_with_false_alarms(),
      report.clean.size(), report.cases);
  text += fmt::format("{:<30}{:<26}{:<28}{:<20}{:<10}{:>18}{:>10}\n", "fault", "method", "caught in", "metric", "by",
                      "error", "scenarios");
  for (const FaultResult& result : report.faults) text += line_of(result);
  text += fmt::format("\nThe fewest scenarios that catch them all: {}.\n",
                      fmt::join(fewest_scenarios(report.faults), ", "));
  return text + false_alarms_text(report) + loose_truths_text(report);
}

Json to_json(const ProveReport& report) {
  Json faults = Json::array();
  for (const FaultResult& result : report.faults) {
    faults.push_back({{"name", result.fault.name},
                      {"about", result.fault.about},
                      {"source", result.fault.source},
                      {"method", method_of(result.fault)},
                      {"caught", result.caught()},
                      {"detections", json_of(result.detections)}});
  }
  Json clean = Json::array();
  Json loose = Json::array();
  for (const CleanRun& run : report.clean) {
    clean.push_back({{"seed", run.seed}, {"settings", run.settings}, {"false_alarms", json_of(run.false_alarms)}});
    for (const LooseTruth& one : run.loose) {
      loose.push_back({{"scenario", one.scenario},
                       {"variant", one.variant},
                       {"what", one.check.what},
                       {"share", number_or_null(one.check.share)}});
    }
  }
  return {{"caught", report.caught()}, {"false_alarms", report.runs_with_false_alarms()},
          {"cases", report.cases},     {"fewest_scenarios", fewest_scenarios(report.faults)},
          {"faults", faults},          {"clean", clean},
          {"not_a_test", loose}};
}

std::string ratio_text(double ratio) {
  if (!std::isfinite(ratio)) return "unbounded";
  return ratio < 1e6 ? fmt::format("{:.3g} x allowed", ratio) : fmt::format("{:.1e} x allowed", ratio);
}

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json to_json(const Detection& one) {
  return {{"scenario", one.scenario},   {"variant", one.variant},
          {"kind", name_of(one.kind)},  {"metric", one.metric},
          {"unit", one.unit},           {"error", number_or_null(one.error)},
          {"tolerance", one.tolerance}, {"ratio", number_or_null(one.ratio)}};
}

}  // namespace plumb
