// The study of stability: maps over two parameters of where each method fails, and whether theory predicts it. Each row
// of a map is one job.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "reports/report.h"
#include "reports/run/catalog_case.h"
#include "reports/study/job.h"
#include "reports/study/results_file.h"
#include "reports/study/stability/headline.h"
#include "reports/study/stability/row.h"
#include "reports/study/study.h"
#include "reports/system/command_options.h"
#include "reports/system/layout.h"
#include "reports/system/terminal.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

struct StabilityOptions {
  std::vector<std::string> maps, engines;
  int cells = 16;
};

const StabilityMap& find_map(const std::string& name) { return find_entry<StabilityMap>("map", name); }

std::vector<const StabilityMap*> maps_of(const Json& configuration) {
  std::vector<const StabilityMap*> maps;
  for (const std::string name : configuration.at("maps")) maps.push_back(&find_map(name));
  return maps.empty() ? Catalog<StabilityMap>::all() : maps;
}

std::vector<double> with(double value, std::vector<double> values) {
  values.push_back(value);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

// The rows of a method: evenly spaced, and the typical one. `option`: what makes the method work harder, or "".
std::vector<RowSetting> rows_of(const StabilityMap& map, const EngineConfig& config, const std::string& option,
                                int cells) {
  constexpr double hardest = 32;  // iterations or sub-steps
  std::vector<RowSetting> rows;
  if (map.y) {
    for (const double y : with(map.typical, map.y->values(cells))) rows.push_back({"", y, y == map.typical, config});
    return rows;
  }
  if (option.empty()) return {{"", 0, true, config}};
  const double standard = std::stod(config.settings.at(option));
  const Axis work{.name = option, .from = 1, .to = hardest, .logarithmic = true, .whole = true};
  for (const double y : with(standard, work.values(cells))) {
    EngineConfig harder = config;
    harder.settings[option] = fmt::format("{}", y);
    rows.push_back({option, y, y == standard, harder});
  }
  return rows;
}

std::vector<Job> jobs_of(const Json& configuration) {
  const int cells = configuration.at("cells");
  const std::vector<Method> methods = select_methods(configuration.at("engines"));
  std::vector<Job> jobs;
  for (const StabilityMap* map : maps_of(configuration)) {
    const std::vector<double> xs = map->x.values(cells);
    for (const Method& method : methods) {
      const std::vector<EngineConfig> variants =
          map->variants ? map->variants(method.config) : std::vector<EngineConfig>{method.config};
      for (const EngineConfig& variant : variants) {
        const std::string name = variant.method();
        for (const RowSetting& row : rows_of(*map, variant, method.ladder.option, cells)) {
          const std::string y_name = map->y ? map->y->name : row.option.empty() ? std::string("alone") : row.option;
          jobs.push_back({.key = fmt::format("stability|{}|{}|{}={}", map->name, label_of(variant.engine->name, name),
                                             y_name, row.y),
                          .run = [=] { return JobOutput{.values = row_values(*map, xs, row, name)}; }});
        }
      }
    }
  }
  return jobs;
}

// Changes when the definition of a map changes.
std::string definitions_hash(const std::vector<const StabilityMap*>& maps, int cells) {
  std::vector<std::string> descriptions;
  descriptions.reserve(maps.size());
  for (const StabilityMap* map : maps) descriptions.push_back(description_of(*map, cells).dump());
  return hash_of_lines(descriptions);
}

Json configuration_of(const StabilityOptions& options) {
  Json configuration{{"maps", options.maps}, {"engines", options.engines}, {"cells", options.cells}};
  configuration["definitions"] = definitions_hash(maps_of(configuration), options.cells);
  require_distinct_keys(jobs_of(configuration));
  return configuration;
}

Json failure_modes_json() {
  Json all = Json::array();
  for (const FailureModeText& text : failure_modes()) {
    all.push_back({{"letter", std::string(1, text.letter)}, {"name", text.name}, {"about", text.about}});
  }
  return all;
}

bool is_done(const JobResult& result) { return result.ending == Ending::done; }

// The values of a method's rows in a map.
struct MethodRows {
  std::string engine;
  std::vector<const Json*> rows = {};
  std::string failed = {};  // why a row has no values
};

// The method of a row's key: stability|MAP|METHOD|ROW.
std::string method_of(const std::string& key, const std::string& map) {
  const std::size_t begin = std::string("stability|").size() + map.size() + 1;
  return key.substr(begin, key.rfind('|') - begin);
}

std::vector<MethodRows> by_method(const std::string& map, const std::vector<JobResult>& results) {
  std::vector<MethodRows> methods;
  for (const JobResult& result : results) {
    if (!result.key.starts_with("stability|" + map + "|")) continue;
    const std::string engine = method_of(result.key, map);
    auto found = std::find_if(methods.begin(), methods.end(), [&](const auto& one) { return one.engine == engine; });
    if (found == methods.end()) found = methods.insert(found, {engine});
    if (is_done(result)) {
      found->rows.push_back(&result.output.values);
    } else if (found->failed.empty()) {
      found->failed = fmt::format("{}, {}", name_of(result.ending), result.reason);
    }
  }
  return methods;
}

std::string bracket_text(const Json& limit) {
  const Json& low = limit.at("low");
  const Json& high = limit.at("high");
  if (low.is_null() && high.is_null()) return "not supported";
  if (low.is_null()) return fmt::format("none: {}", limit.at("outcome").get<std::string>());
  if (high.is_null()) {
    return fmt::format("{:.4g} and {}", low.get<double>(),
                       limit.at("why").get<std::string>().empty() ? "more" : "more is not supported");
  }
  return fmt::format("{:.4g} ({:.4g}: {})", low.get<double>(), high.get<double>(),
                     limit.at("outcome").get<std::string>());
}

std::string text_of(const StabilityMap& map, const Json& described, std::size_t width) {
  const auto with_unit = [](const Axis& axis) { return axis.unit.empty() ? axis.name : axis.name + ", " + axis.unit; };
  const std::string where =
      map.y ? fmt::format("{} = {:.4g}{}{}", map.y->name, map.typical, map.y->unit.empty() ? "" : " ", map.y->unit)
            : "each method's default work";
  const Json& agreements = described.at("agreements");
  TextTable table({{"method", 0, true}, {with_unit(map.x), 0, true}, {"as theory says", 2}, {"off by", 3}}, 2, width);
  std::string failures;
  for (const Json& limit : described.at("limits")) {
    const std::string engine = limit.at("engine");
    if (!limit.contains("low")) {
      failures += wrapped(fmt::format("{} failed: {}", engine, limit.value("failed", "its row is missing")), 2, width);
      continue;
    }
    std::string agree, off;
    for (const Json& one : agreements) {
      if (one.at("engine") != engine || one.at("boundary") != map.boundaries[0].name) continue;
      agree = fmt::format("{}/{}", one.at("agree").get<int>(), one.at("rows").get<int>());
      if (one.at("worst").is_number()) off = fmt::format("{:.2g}", one.at("worst").get<double>());
    }
    table.add({{engine}, {bracket_text(limit)}, {agree}, {off}});
  }
  return wrapped(fmt::format("{}: {} At {}.", map.name, map.question, where), 0, width) + table.text() + failures +
         "\n";
}

// A row is failed if any of its cells is.
std::string why_failed(const JobResult& result) {
  const Json& values = result.output.values;
  const std::string outcomes = values.at("outcomes");
  return outcomes.find(letter_of(FailureMode::fails)) == std::string::npos ? "" : values.at("why").get<std::string>();
}

Findings conclude(const std::vector<const StabilityMap*>& maps, int cells, const std::vector<JobResult>& results) {
  const std::size_t width = terminal_width(120);
  Findings found;
  Json all = Json::array();
  for (const StabilityMap* map : maps) {
    Json described = description_of(*map, cells);
    described["agreements"] = Json::array();
    described["limits"] = Json::array();
    for (const auto& [engine, rows, failed] : by_method(map->name, results)) {
      described["limits"].push_back(limit_json(engine, rows, map->boundaries[0].name));
      if (!failed.empty()) described["limits"].back()["failed"] = failed;
      for (const Boundary& boundary : map->boundaries) {
        if (Json agreement = agreement_json(engine, rows, boundary.name); !agreement.is_null()) {
          described["agreements"].push_back(std::move(agreement));
        }
      }
    }
    found.text += text_of(*map, described, width);
    all.push_back(std::move(described));
  }
  find_best(all);
  const std::string sentence = sentence_of(all);
  const Json failures = failures_of(results, why_failed);
  found.text = wrapped(sentence, 0, width) + "\n" + found.text;
  found.findings = {
      {"sentence", sentence}, {"outcomes", failure_modes_json()}, {"maps", std::move(all)}, {"failures", failures}};
  const auto unfinished = std::count_if(results.begin(), results.end(), [](const auto& one) { return !is_done(one); });
  found.text += failures_text(failures);
  found.text += fmt::format("{} rows; {} crashed or exceeded their limits.\n", results.size(), unfinished);
  return found;
}

const Catalog<Study>::Entry stability_entry{
    {.name = "stability",
     .about = "Where each method fails, and whether theory predicts it: maps over two parameters with bisected "
              "boundaries",
     .examples = "  plumb study stability                                 every map, every method\n"
                 "  plumb study stability --maps stack tunnelling         some maps\n"
                 "  plumb study stability --engine impulse --cells 32     one method, in finer cells\n",
     .attach = [](CLI::App& app) -> std::function<Json()> {
       const auto options = std::make_shared<StabilityOptions>();
       std::string names;
       for (const StabilityMap* map : Catalog<StabilityMap>::all()) names += (names.empty() ? "" : ", ") + map->name;
       CommandOptions add(app);
       add.add("--maps", "NAME", options->maps, "Any of: " + names + ". Default: all");
       add.add_repeated("--engine", "ENGINE", options->engines,
                        "NAME[:key=value,...]; may be repeated. Default: every engine and method");
       add.add("--cells", "N", options->cells, 2, 1000, "Cells along each axis of a map");
       return [options] { return configuration_of(*options); };
     },
     .plan = [](const Json& configuration) -> StudyPlan {
       const int cells = configuration.at("cells");
       return {jobs_of(configuration), [maps = maps_of(configuration), cells](const std::vector<JobResult>& results) {
                 return conclude(maps, cells, results);
               }};
     },
     .summary = [](const std::vector<std::string>& engines) -> std::optional<std::vector<std::string>> {
       return with_engines({"--maps", "mass-ratio", "slope", "stack", "tunnelling", "--cells", "6"}, engines);
     }}};

}  // namespace
}  // namespace plumb
