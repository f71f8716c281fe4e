// Where methods fail, and whether theory said so: maps over two numbers, a row of a map a point.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>

#include "reports/report.h"
#include "reports/study/methods.h"
#include "reports/study/results_file.h"
#include "reports/study/stability/findings.h"
#include "reports/study/stability/row.h"
#include "reports/study/study.h"
#include "scenarios/scene/nearest.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

struct Asked {
  std::vector<std::string> maps, engines;
  int cells = 16;
};

const StabilityMap& find_map(const std::string& name) {
  const StabilityMap* found = Catalog<StabilityMap>::find(name);
  if (found != nullptr) return *found;
  std::vector<std::string> names;
  for (const StabilityMap* map : Catalog<StabilityMap>::all()) names.push_back(map->name);
  throw std::invalid_argument(unknown("map", name, names));
}

std::vector<const StabilityMap*> maps_of(const Json& configuration) {
  std::vector<const StabilityMap*> maps;
  for (const std::string name : configuration.at("maps")) maps.push_back(&find_map(name));
  return maps.empty() ? Catalog<StabilityMap>::all() : maps;
}

// A row's place in its map.
struct Place {
  std::string option;  // that makes the method work harder; "" where y is the map's own
  double y = 0;
  bool typical = false;
  EngineConfig config;
};

constexpr double hardest = 32;  // iterations, or sub-steps

// Evenly spread, and the typical one among them.
std::vector<double> with(double typical, std::vector<double> values) {
  values.push_back(typical);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::vector<Place> places_of(const StabilityMap& map, const EngineConfig& config, const std::string& option,
                             int cells) {
  std::vector<Place> places;
  if (map.y) {
    for (const double y : with(map.typical, map.y->values(cells))) {
      places.push_back({"", y, y == map.typical, config});
    }
    return places;
  }
  if (option.empty()) return {{"", 0, true, config}};
  const double standard = std::stod(config.settings.at(option));
  const Axis work{.name = option, .from = 1, .to = hardest, .logarithmic = true, .whole = true};
  for (const double y : with(standard, work.values(cells))) {
    EngineConfig harder = config;
    harder.settings[option] = fmt::format("{}", y);
    places.push_back({option, y, y == standard, harder});
  }
  return places;
}

Json optional_number(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

// A theory that lets a method hold always is told in a word, as JSON knows no infinity.
Json theory_json(const std::optional<double>& theory) {
  return theory && std::isinf(*theory) ? Json("never") : optional_number(theory);
}

Row found(const StabilityMap& map, const std::vector<double>& xs, const Place& place, const std::string& method) {
  const MapRow row = row_of(map, xs, place.y, place.config);
  std::string outcomes;
  Json since = Json::array();
  Json bodies = Json::array();
  std::string why;
  for (const Seen& seen : row.cells) {
    outcomes += letter_of(seen.fate);
    since.push_back(is_failure(seen.fate) ? Json(seen.time) : Json(nullptr));
    bodies.push_back(seen.body);
    if (why.empty()) why = seen.why;
  }
  Row made;
  made.values = {{"map", map.name},      {"engine", place.config.engine->name},
                 {"method", method},     {"option", place.option},
                 {"y", place.y},         {"typical", place.typical},
                 {"outcomes", outcomes}, {"why", why},
                 {"since", since},       {"bodies", bodies}};
  for (std::size_t i = 0; i < map.boundaries.size(); ++i) {
    const Boundary& boundary = map.boundaries[i];
    const Bracket& bracket = row.brackets[i];
    const auto theory = boundary.theory ? boundary.theory(place.config, place.y) : std::nullopt;
    made.values[boundary.name + "_low"] = optional_number(bracket.low);
    made.values[boundary.name + "_high"] = optional_number(bracket.high);
    made.values[boundary.name + "_outcome"] = bracket.high ? name_of(bracket.seen.fate) : "";
    made.values[boundary.name + "_time"] = bracket.high ? Json(bracket.seen.time) : Json(nullptr);
    made.values[boundary.name + "_body"] = bracket.seen.body;
    made.values[boundary.name + "_theory"] = theory_json(theory);
    if (!theory || !(bracket.low || bracket.high)) continue;
    const Agreement agreement = agreement_of(map.x, boundary, bracket.low, bracket.high, *theory);
    made.values[boundary.name + "_agrees"] = agreement.agrees;
    made.values[boundary.name + "_off"] = optional_number(agreement.off);
  }
  return made;
}

std::vector<Point> points_of(const Json& configuration) {
  const int cells = configuration.at("cells");
  const std::vector<Method> methods = methods_asked(configuration.at("engines"));
  std::vector<Point> points;
  for (const StabilityMap* map : maps_of(configuration)) {
    const std::vector<double> xs = map->x.values(cells);
    for (const Method& method : methods) {
      const std::vector<EngineConfig> variants =
          map->variants ? map->variants(method.config) : std::vector<EngineConfig>{method.config};
      for (const EngineConfig& variant : variants) {
        const std::string name = variant.method();
        for (const Place& place : places_of(*map, variant, method.ladder.option, cells)) {
          const std::string row = map->y ? map->y->name : place.option.empty() ? std::string("alone") : place.option;
          points.push_back({.key = fmt::format("stability|{}|{}|{}={}", map->name, label_of(variant.engine->name, name),
                                               row, place.y),
                            .run = [=] { return found(*map, xs, place, name); }});
        }
      }
    }
  }
  return points;
}

// Tells maps that have changed since from those that were drawn.
std::string hash_of(const std::vector<const StabilityMap*>& maps, int cells) {
  std::vector<Point> described;
  for (const StabilityMap* map : maps) described.push_back({.key = description_of(*map, cells).dump()});
  return plan_hash(described);
}

Json configuration_of(const Asked& asked) {
  Json configuration{{"maps", asked.maps}, {"engines", asked.engines}, {"cells", asked.cells}};
  configuration["definitions"] = hash_of(maps_of(configuration), asked.cells);
  std::set<std::string> seen;
  for (const Point& point : points_of(configuration)) {
    if (!seen.insert(point.key).second) throw std::invalid_argument("\"" + point.key + "\" is asked for twice");
  }
  return configuration;
}

const Catalog<Study>::Entry stability_entry{
    {.name = "stability",
     .about = "Where each method fails, and whether theory said so: maps over two numbers with bisected boundaries",
     .examples = "  plumb study stability                                 every map, every method\n"
                 "  plumb study stability --maps stack tunnelling         some maps\n"
                 "  plumb study stability --engine impulse --cells 32     one method, in finer cells\n",
     .attach = [](CLI::App& app) -> std::function<Json()> {
       const auto asked = std::make_shared<Asked>();
       std::string names;
       for (const StabilityMap* map : Catalog<StabilityMap>::all()) names += (names.empty() ? "" : ", ") + map->name;
       app.add_option("--maps", asked->maps, "Which of: " + names + ". Default: all")->type_name("NAME");
       app.add_option("--engine", asked->engines,
                      "NAME[:key=value,...]; may be repeated. Default: every engine and method")
           ->allow_extra_args(false)
           ->type_name("ENGINE");
       app.add_option("--cells", asked->cells, "Of a map, along each of its axes")
           ->capture_default_str()
           ->check(CLI::Range(2, 1000))
           ->type_name("N");
       return [asked] { return configuration_of(*asked); };
     },
     .plan = [](const Json& configuration) -> StudyPlan {
       const int cells = configuration.at("cells");
       return {points_of(configuration),
               [maps = maps_of(configuration), cells](const std::vector<PointResult>& results) {
                 return stability_findings(maps, cells, results);
               }};
     },
     .brief = {{"--maps", "mass-ratio", "slope", "stack", "tunnelling", "--cells", "6"}}}};

}  // namespace
}  // namespace plumb
