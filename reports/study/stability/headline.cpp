#include "reports/study/stability/headline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "reports/system/layout.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

// By method, in the order of its first map.
std::vector<std::pair<std::string, int>> maps_of_methods(const Json& maps) {
  std::vector<std::pair<std::string, int>> all;
  for (const Json& map : maps) {
    for (const Json& limit : map.at("limits")) {
      const std::string engine = limit.at("engine");
      const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == engine; });
      if (found == all.end()) {
        all.emplace_back(engine, 1);
      } else {
        ++found->second;
      }
    }
  }
  return all;
}

std::vector<std::string> compared(const Json& maps) {
  std::vector<std::string> engines;
  for (const auto& [engine, count] : maps_of_methods(maps)) {
    if (count > 1 || maps.size() == 1) engines.push_back(engine);
  }
  return engines;
}

bool natural(const Json& map) { return map.at("boundaries").at(0).at("natural"); }

// The last value that holds, as a fraction of the axis; negative if none holds.
double extent_of(const Json& axis, const Json& limit) {
  if (!limit.contains("low") || !limit.at("low").is_number()) return -1;
  const double low = limit.at("low"), from = axis.at("from"), to = axis.at("to");
  return axis.at("logarithmic") ? std::log(low / from) / std::log(to / from) : (low - from) / (to - from);
}

bool is_best(const Json& map, const std::string& engine) {
  const Json& best = map.at("best");
  return std::find(best.begin(), best.end(), engine) != best.end();
}

std::string in_words(std::string name) {
  std::replace(name.begin(), name.end(), '-', ' ');
  return name;
}

// "in arch box2d holds farther": of a map in which a method is not among the best.
std::string shortfall(const Json& map) {
  const std::string where = "in " + in_words(map.at("name"));
  const bool lawful = natural(map);
  if (map.at("best").empty()) return where + (lawful ? " no method is as theory says" : " no method holds at all");
  return fmt::format("{} {} {}", where, map.at("best")[0].get<std::string>(),
                     lawful ? "is as theory says" : "holds farther");
}

}  // namespace

void find_best(Json& maps) {
  const std::vector<std::string> engines = compared(maps);
  for (Json& map : maps) {
    Json best = Json::array();
    double farthest = 0;
    for (const Json& limit : map.at("limits")) {
      const std::string engine = limit.at("engine");
      if (std::find(engines.begin(), engines.end(), engine) == engines.end()) continue;
      const double extent = extent_of(map.at("x"), limit);
      if (!natural(map) && extent > farthest) {
        best.clear();
        farthest = extent;
      }
      if (natural(map) ? limit.value("agrees", false) : extent >= farthest) best.push_back(engine);
    }
    map["best"] = std::move(best);
  }
}

std::string sentence_of(const Json& maps) {
  std::string most;
  std::ptrdiff_t wins = 0;
  for (const std::string& engine : compared(maps)) {
    const auto won = std::count_if(maps.begin(), maps.end(), [&](const Json& map) { return is_best(map, engine); });
    if (won <= wins) continue;
    wins = won;
    most = engine;
  }
  const std::string all = fmt::format("{} map{}", maps.size(), maps.size() == 1 ? "" : "s");
  std::string text = all;
  if (wins > 0) {
    text = fmt::format("{} is the best or among the best in {} of {}", most, wins, all);
    std::vector<std::string> parts;
    for (const Json& map : maps) {
      if (!is_best(map, most)) parts.push_back(shortfall(map));
    }
    if (!parts.empty()) text += ", but " + enumerated(parts);
  }
  int rows = 0;
  int agree = 0;
  for (const Json& map : maps) {
    for (const Json& one : map.at("agreements")) {
      rows += one.at("rows").get<int>();
      agree += one.at("agree").get<int>();
    }
  }
  if (rows > 0) text += fmt::format(". Of all methods' boundaries with a theory, {} of {} agree with it", agree, rows);
  return text + ".";
}

}  // namespace plumb
