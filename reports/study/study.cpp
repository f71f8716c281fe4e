#include "reports/study/study.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "reports/report.h"
#include "reports/run/selection.h"
#include "reports/study/job.h"
#include "reports/study/results_file.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {
namespace {

Method parse_method(const std::string& word) {
  const EngineConfig config = parse_engine(word);
  for (const WorkLadder& ladder : config.engine->ladders) {
    const Settings own = complete(*config.engine, ladder.method);
    const auto same = [&](const auto& setting) { return config.settings.at(setting.first) == setting.second; };
    if (std::all_of(own.begin(), own.end(), same)) return {config, ladder};
  }
  return {config, {}};
}

}  // namespace

std::vector<std::string> with_engines(std::vector<std::string> options, const std::vector<std::string>& engines) {
  for (const std::string& engine : engines) options.insert(options.end(), {"--engine", engine});
  return options;
}

std::vector<Method> default_methods() {
  std::vector<Method> all;
  for (const EngineConfig& config : default_engines()) {
    const Engine& engine = *config.engine;
    if (engine.ladders.empty()) all.push_back({config, {}});
    // Configurations other than the default are among the ladders' methods.
    if (!config.method().empty()) continue;
    for (const WorkLadder& ladder : engine.ladders) all.push_back({{&engine, complete(engine, ladder.method)}, ladder});
  }
  return all;
}

std::vector<Method> select_methods(const std::vector<std::string>& words) {
  if (words.empty()) return default_methods();
  std::vector<Method> all;
  std::transform(words.begin(), words.end(), std::back_inserter(all), parse_method);
  return all;
}

std::string engine_label(const nlohmann::ordered_json& values) {
  return label_of(values.at("engine"), values.at("method"));
}

std::string hash_of(const std::vector<Case>& cases) {
  std::vector<std::string> scenes;
  for (const Case& one : cases) scenes.push_back(write_scene({*one.scene, {}}));
  return hash_of_lines(scenes);
}

void require_distinct_keys(std::span<const Job> jobs) {
  std::vector<std::string> keys;
  for (const Job& job : jobs) keys.push_back(job.key);
  require_distinct(keys);
}

}  // namespace plumb
