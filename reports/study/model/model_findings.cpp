#include "reports/study/model/model_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

struct Place {
  std::string name;
  const PointResult* full = nullptr;
  const PointResult* chosen = nullptr;  // by the engine
  const PointResult* least = nullptr;
  std::vector<const PointResult*> drops;
};

std::string role_of(const PointResult& point) { return point.row.values.value("role", ""); }

// Points of a case follow each other; one that did not come to its end still has its key: model|SCENARIO/VARIANT|NAME.
std::vector<Place> places_of(const std::vector<PointResult>& results) {
  std::vector<Place> places;
  for (const PointResult& point : results) {
    const std::size_t begin = point.key.find('|') + 1;
    const std::string name = point.key.substr(begin, point.key.rfind('|') - begin);
    if (places.empty() || places.back().name != name) places.push_back({.name = name});
    Place& place = places.back();
    if (point.ending != Ending::done) continue;
    if (role_of(point) == "full") place.full = &point;
    if (role_of(point) == "auto") place.chosen = &point;
    if (role_of(point) == "least") place.least = &point;
    if (role_of(point) == "drop") place.drops.push_back(&point);
  }
  return places;
}

Json ratio(const Json& over, const Json& under) {
  if (!over.is_number() || !under.is_number() || !(under.get<double>() > 0)) return nullptr;
  return over.get<double>() / under.get<double>();
}

Json median_of(const Json& times) { return times.contains("median") ? times.at("median") : Json(nullptr); }

// What its own choice promises: never less accurate than asked.
Json promise_of(const Place& place) {
  if (place.chosen == nullptr) return {{"place", place.name}, {"kept", false}, {"change", nullptr}};
  const Json& values = place.chosen->row.values;
  return {{"place", place.name}, {"kept", values.at("within")}, {"change", values.at("change")}};
}

Json costs_of(const Place& place) {
  const Json full = median_of(place.full->row.times);
  Json drops = Json::array();
  for (const PointResult* drop : place.drops) {
    drops.push_back({{"setting", drop->row.values.at("setting")}, {"ratio", ratio(median_of(drop->row.times), full)}});
  }
  Json costs{{"place", place.name}, {"full", full}, {"drops", std::move(drops)}, {"least", nullptr}};
  if (place.least == nullptr || !place.least->row.times.contains("line")) return costs;
  costs["least"] = place.least->row.times;
  return costs;
}

std::string times_text(const Json& number) {
  return number.is_number() ? fmt::format("{:.2f}", number.get<double>()) : "-";
}

std::string summary_of(const Json& promises, const Json& costs) {
  std::string text = fmt::format("{:<28}{:>10}{:>10}{:>12}  {}\n", "cheaper than the full model", "least", "auto",
                                 "auto worse", "least model");
  for (const Json& cost : costs) {
    const std::string name = cost.at("place");
    const auto promise =
        std::find_if(promises.begin(), promises.end(), [&](const Json& one) { return one.at("place") == name; });
    const bool found = cost.at("least").is_object();
    const bool kept = promise->at("kept");
    text += fmt::format("{:<28}{:>10}{:>10}{:>12}  {}\n", name,
                        found ? times_text(cost.at("least").at("cheaper").at("median")) : "-",
                        found ? times_text(cost.at("least").at("auto_cheaper").at("median")) : "-", kept ? "no" : "YES",
                        found ? cost.at("least").at("line").get<std::string>() : "none found");
  }
  const auto broken =
      std::count_if(promises.begin(), promises.end(), [](const Json& one) { return !one.at("kept").get<bool>(); });
  return text + fmt::format("\nimpulse:auto is within the tolerance in {} of {} cases.\n",
                            promises.size() - static_cast<std::size_t>(broken), promises.size());
}

}  // namespace

Findings model_findings(const std::vector<PointResult>& results) {
  Json promises = Json::array();
  Json costs = Json::array();
  for (const Place& place : places_of(results)) {
    if (place.full == nullptr) continue;
    promises.push_back(promise_of(place));
    costs.push_back(costs_of(place));
  }
  Findings found;
  found.findings = {{"promises", promises}};
  found.timings = {{"cases", costs}};
  found.summary = summary_of(promises, costs);
  return found;
}

}  // namespace plumb
