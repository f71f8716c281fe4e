#include "reports/prove/document.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

std::string times(double ratio) {
  if (!std::isfinite(ratio)) return "without bound";
  return ratio < 1e6 ? fmt::format("{:.3g} x allowed", ratio) : fmt::format("{:.1e} x allowed", ratio);
}

std::string method_of(const Fault& fault) {
  std::string text;
  for (const auto& [option, value] : fault.method) text += (text.empty() ? "" : ",") + value;
  return text.empty() ? "accurate" : text;
}

std::string where(const Alarm& alarm) { return alarm.scenario + (alarm.variant.empty() ? "" : " " + alarm.variant); }

std::string row(const Proof& proof) {
  const Alarm* best = proof.best();
  if (best == nullptr) {
    return fmt::format("{:<30}{:<26}{}\n", proof.fault.name, method_of(proof.fault),
                       proof.alarms.empty() ? "NOT SEEN: the same bits everywhere" : "NOT SEEN: other bits alone");
  }
  return fmt::format("{:<30}{:<26}{:<28}{:<20.20}{:<10}{:>18}{:>5}\n", proof.fault.name, method_of(proof.fault),
                     where(*best), best->metric, name_of(best->means), times(best->ratio), proof.scenarios().size());
}

Json json_of(const Alarm& alarm) {
  const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
  return {{"scenario", alarm.scenario},   {"variant", alarm.variant},    {"means", name_of(alarm.means)},
          {"metric", alarm.metric},       {"unit", alarm.unit},          {"off", number(alarm.off)},
          {"tolerance", alarm.tolerance}, {"ratio", number(alarm.ratio)}};
}

Json json_of(const std::vector<Alarm>& alarms) {
  Json list = Json::array();
  for (const Alarm& alarm : alarms) list.push_back(json_of(alarm));
  return list;
}

}  // namespace

std::size_t Proven::caught() const {
  return static_cast<std::size_t>(
      std::count_if(proofs.begin(), proofs.end(), [](const Proof& proof) { return proof.caught(); }));
}

std::size_t Proven::caught_by_physics() const {
  return static_cast<std::size_t>(
      std::count_if(proofs.begin(), proofs.end(), [](const Proof& proof) { return proof.caught_by_physics(); }));
}

std::size_t Proven::false_alarms() const {
  return static_cast<std::size_t>(
      std::count_if(clean.begin(), clean.end(), [](const CleanRun& run) { return !run.alarms.empty(); }));
}

bool Proven::holds() const { return caught() == proofs.size() && false_alarms() == 0; }

std::string text_of(const Proven& proven) {
  std::string text = fmt::format(
      "{} of {} faults caught, {} of them by truth or invariant; {} false alarms in {} clean runs; cases: {}.\n\n",
      proven.caught(), proven.proofs.size(), proven.caught_by_physics(), proven.false_alarms(), proven.clean.size(),
      proven.cases);
  text += fmt::format("{:<30}{:<26}{:<28}{:<20}{:<10}{:>18}{:>5}\n", "fault", "in", "caught by", "metric", "means",
                      "by how much", "of");
  for (const Proof& proof : proven.proofs) text += row(proof);
  text += fmt::format("\nThe fewest scenarios that catch them all: {}.\n",
                      fmt::join(fewest_scenarios(proven.proofs), ", "));
  for (const CleanRun& run : proven.clean) {
    for (const Alarm& alarm : run.alarms) {
      text += fmt::format("FALSE ALARM in {}: {}, {}, {:.3g} {} where {:.3g} is allowed\n", run.settings, where(alarm),
                          alarm.metric, alarm.off, alarm.unit, alarm.tolerance);
    }
  }
  return text;
}

Json to_json(const Proven& proven) {
  Json faults = Json::array();
  for (const Proof& proof : proven.proofs) {
    faults.push_back({{"name", proof.fault.name},
                      {"about", proof.fault.about},
                      {"source", proof.fault.source},
                      {"in", method_of(proof.fault)},
                      {"caught", proof.caught()},
                      {"alarms", json_of(proof.alarms)}});
  }
  Json clean = Json::array();
  for (const CleanRun& run : proven.clean) {
    clean.push_back({{"seed", run.seed}, {"settings", run.settings}, {"alarms", json_of(run.alarms)}});
  }
  return {{"caught", proven.caught()}, {"false_alarms", proven.false_alarms()},
          {"cases", proven.cases},     {"fewest_scenarios", fewest_scenarios(proven.proofs)},
          {"faults", faults},          {"clean", clean}};
}

}  // namespace plumb
