#include "reports/run/plan_selection.h"

#include <set>
#include <stdexcept>
#include <utility>

#include "reports/run/selection.h"

namespace plumb {

std::vector<Case> select_cases(const std::vector<std::string>& words, bool all, const std::vector<std::string>& extra) {
  std::vector<Case> cases;
  if (words.empty()) cases = default_cases(all);
  std::vector<std::string> named = words;
  if (words.empty() && !all) named = extra;
  for (const std::string& word : named) {
    for (Case& one : parse_cases(word)) cases.push_back(std::move(one));
  }
  return cases;
}

Plan select_plan(const std::vector<std::string>& words, bool all, const std::vector<std::string>& engines) {
  Plan plan{.cases = select_cases(words, all, {})};
  for (const std::string& word : engines) plan.configs.push_back(parse_engine(word));
  if (engines.empty()) plan.configs = default_engines();
  std::vector<std::string> names;
  for (const Case& one : plan.cases) names.push_back(one.scenario->name + ":" + one.variant);
  for (const EngineConfig& config : plan.configs) names.push_back(label_of(config.engine->name, config.method()));
  require_distinct(names);
  return plan;
}

void require_distinct(std::span<const std::string> names) {
  std::set<std::string> distinct;
  for (const std::string& name : names) {
    if (!distinct.insert(name).second) throw std::invalid_argument("\"" + name + "\" is selected twice");
  }
}

}  // namespace plumb
