#include "reports/methods.h"

#include <algorithm>

#include "reports/cli.h"

namespace plumb {
namespace {

Method parse_method(const std::string& word) {
  const Entrant entrant = parse_entrant(word);
  for (const WorkLadder& ladder : entrant.contender->ladders) {
    const Settings own = complete(*entrant.contender, ladder.method);
    const auto same = [&](const auto& setting) { return entrant.settings.at(setting.first) == setting.second; };
    if (std::all_of(own.begin(), own.end(), same)) return {entrant, ladder};
  }
  return {entrant, {}};
}

}  // namespace

std::vector<Method> default_methods() {
  std::vector<Method> all;
  for (const Entrant& entrant : default_entrants()) {
    const Contender& contender = *entrant.contender;
    if (contender.ladders.empty()) all.push_back({entrant, {}});
    // What is shown beside the default is among the ladders' methods.
    if (!entrant.method().empty()) continue;
    for (const WorkLadder& ladder : contender.ladders)
      all.push_back({{&contender, complete(contender, ladder.method)}, ladder});
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
