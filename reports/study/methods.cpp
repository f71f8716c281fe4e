#include "reports/study/methods.h"

#include <algorithm>

#include "reports/run/selection.h"

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

std::vector<Method> default_methods() {
  std::vector<Method> all;
  for (const EngineConfig& config : default_engines()) {
    const Engine& engine = *config.engine;
    if (engine.ladders.empty()) all.push_back({config, {}});
    // What is shown beside the default is among the ladders' methods.
    if (!config.method().empty()) continue;
    for (const WorkLadder& ladder : engine.ladders) all.push_back({{&engine, complete(engine, ladder.method)}, ladder});
  }
  return all;
}

std::vector<Method> methods_asked(const std::vector<std::string>& words) {
  if (words.empty()) return default_methods();
  std::vector<Method> all;
  std::transform(words.begin(), words.end(), std::back_inserter(all), parse_method);
  return all;
}

}  // namespace plumb
