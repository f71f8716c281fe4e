#include "reports/study/stability/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "reports/report.h"
#include "reports/study/methods.h"

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

Json outcomes_json() {
  Json all = Json::array();
  for (const FateText& text : fates()) {
    all.push_back({{"letter", std::string(1, text.letter)}, {"name", text.name}, {"about", text.about}});
  }
  return all;
}

std::string engine_of(const Json& values) { return label_of(values.at("engine"), values.at("method")); }

bool known(const PointResult& point) { return point.ending == Ending::done; }

// The rows of one method in one map.
struct Curve {
  std::string engine;
  std::vector<const Json*> rows;
};

std::vector<Curve> curves_of(const std::string& map, const std::vector<PointResult>& results) {
  std::vector<Curve> curves;
  for (const PointResult& point : results) {
    if (!known(point) || point.row.values.at("map") != map) continue;
    const std::string engine = engine_of(point.row.values);
    auto found = std::find_if(curves.begin(), curves.end(), [&](const Curve& one) { return one.engine == engine; });
    if (found == curves.end()) found = curves.insert(found, {engine, {}});
    found->rows.push_back(&point.row.values);
  }
  return curves;
}

// How a method's rows stand to a theory, all together.
std::optional<Json> agreement_json(const Curve& curve, const Boundary& boundary) {
  int rows = 0;
  int agree = 0;
  int measured = 0;
  double worst = 0;
  for (const Json* row : curve.rows) {
    const auto agrees = row->find(boundary.name + "_agrees");
    if (agrees == row->end()) continue;
    ++rows;
    if (*agrees) ++agree;
    const Json& off = row->at(boundary.name + "_off");
    if (!off.is_number()) continue;
    ++measured;
    worst = std::max(worst, off.get<double>());
  }
  if (rows == 0) return std::nullopt;
  return Json{{"engine", curve.engine}, {"boundary", boundary.name},
              {"rows", rows},           {"agree", agree},
              {"measured", measured},   {"worst", measured > 0 ? Json(worst) : Json(nullptr)}};
}

// What a method stands in a map where methods are compared.
Json stand_json(const Curve& curve, const Boundary& boundary) {
  const auto typical =
      std::find_if(curve.rows.begin(), curve.rows.end(), [](const Json* row) { return row->at("typical") == true; });
  Json stands{{"engine", curve.engine}};
  if (typical == curve.rows.end()) return stands;
  const Json& row = **typical;
  for (const char* what : {"low", "high", "outcome", "theory"}) stands[what] = row.at(boundary.name + "_" + what);
  stands["y"] = row.at("y");
  stands["option"] = row.at("option");
  stands["why"] = row.at("why");
  return stands;
}

std::string bracket_text(const Json& stands) {
  const Json& low = stands.at("low");
  const Json& high = stands.at("high");
  if (low.is_null() && high.is_null()) return "not supported";
  if (low.is_null()) return fmt::format("none: {}", stands.at("outcome").get<std::string>());
  if (high.is_null()) {
    return fmt::format("{:.4g} and {}", low.get<double>(),
                       stands.at("why").get<std::string>().empty() ? "more" : "no more supported");
  }
  return fmt::format("{:.4g} ({:.4g}: {})", low.get<double>(), high.get<double>(),
                     stands.at("outcome").get<std::string>());
}

std::string unit_of(const Axis& axis) { return axis.unit.empty() ? axis.name : axis.name + ", " + axis.unit; }

std::string summary_of(const StabilityMap& map, const Json& told) {
  const std::string where =
      map.y ? fmt::format("{} = {:.4g}{}{}", map.y->name, map.typical, map.y->unit.empty() ? "" : " ", map.y->unit)
            : "each method's own work";
  std::string text = fmt::format("{}: {}\n  {:<64}{} at {}{}\n", map.name, map.question, "", unit_of(map.x), where,
                                 told.at("agreements").empty() ? "" : "; rows as theory says");
  for (const Json& stands : told.at("stands")) {
    if (!stands.contains("low")) continue;
    std::string as_theory;
    for (const Json& one : told.at("agreements")) {
      if (one.at("engine") != stands.at("engine") || one.at("boundary") != map.boundaries[0].name) continue;
      as_theory = fmt::format("{}/{}", one.at("agree").get<int>(), one.at("rows").get<int>());
      if (one.at("worst").is_number())
        as_theory += fmt::format(", off by {:.2g} at most", one.at("worst").get<double>());
    }
    text += fmt::format("  {:<64}{:<36}{}\n", stands.at("engine").get<std::string>(), bracket_text(stands), as_theory);
  }
  return text + "\n";
}

}  // namespace

Json description_of(const StabilityMap& map, int cells) {
  // Metrics are the same in words for every cell and method, up to their numbers: told of the default method's.
  const Method first = default_methods().front();
  Json metrics = Json::array();
  const std::vector<Trial> trials = map.trials(map.x.from, map.typical, first.config);
  for (const Watch& watch : trials.front().watches) metrics.push_back(watch.metric);
  Json boundaries = Json::array();
  for (const Boundary& boundary : map.boundaries) {
    Json failing = Json::array();
    for (const Fate fate : boundary.failing) failing.push_back(name_of(fate));
    boundaries.push_back({{"name", boundary.name},
                          {"failing", failing},
                          {"grain", boundary.grain},
                          {"source", boundary.source},
                          {"agreement", boundary.agreement},
                          {"natural", boundary.natural}});
  }
  Json described{{"name", map.name},        {"question", map.question},
                 {"x", axis_json(map.x)},   {"y", map.y ? axis_json(*map.y) : Json(nullptr)},
                 {"typical", map.typical},  {"metrics", metrics},
                 {"boundaries", boundaries}};
  described["x"]["values"] = map.x.values(cells);
  return described;
}

Findings stability_findings(const std::vector<const StabilityMap*>& maps, int cells,
                            const std::vector<PointResult>& results) {
  Findings found;
  Json all = Json::array();
  for (const StabilityMap* map : maps) {
    Json told = description_of(*map, cells);
    told["agreements"] = Json::array();
    told["stands"] = Json::array();
    for (const Curve& curve : curves_of(map->name, results)) {
      told["stands"].push_back(stand_json(curve, map->boundaries[0]));
      for (const Boundary& boundary : map->boundaries) {
        if (auto agreement = agreement_json(curve, boundary)) told["agreements"].push_back(*std::move(agreement));
      }
    }
    found.summary += summary_of(*map, told);
    all.push_back(std::move(told));
  }
  found.findings = {{"outcomes", outcomes_json()}, {"maps", std::move(all)}};
  const auto broken =
      std::count_if(results.begin(), results.end(), [](const PointResult& point) { return !known(point); });
  found.summary += fmt::format("{} rows of cells; {} crashed or went beyond their limits.\n", results.size(), broken);
  return found;
}

}  // namespace plumb
