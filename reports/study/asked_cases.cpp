#include "reports/study/asked_cases.h"

#include <set>
#include <stdexcept>
#include <utility>

#include "reports/run/selection.h"
#include "reports/study/results_file.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {
namespace {

void must_be_new(const std::string& name, std::set<std::string>& seen) {
  if (!seen.insert(name).second) throw std::invalid_argument("\"" + name + "\" is asked for twice");
}

}  // namespace

std::vector<Case> cases_asked(const std::vector<std::string>& words, bool all,
                              const std::vector<std::string>& besides) {
  std::vector<Case> cases;
  if (words.empty()) cases = default_cases(all);
  std::vector<std::string> asked = words;
  if (words.empty() && !all) asked = besides;
  for (const std::string& word : asked) {
    for (Case& one : parse_cases(word)) cases.push_back(std::move(one));
  }
  return cases;
}

Plan plan_asked(const std::vector<std::string>& words, bool all, const std::vector<std::string>& engines) {
  Plan plan{.cases = cases_asked(words, all, {})};
  for (const std::string& word : engines) plan.configs.push_back(parse_engine(word));
  if (engines.empty()) plan.configs = default_engines();
  std::set<std::string> seen;
  for (const Case& one : plan.cases) must_be_new(one.scenario->name + ":" + one.variant, seen);
  for (const EngineConfig& one : plan.configs) must_be_new(label_of(one.engine->name, one.method()), seen);
  return plan;
}

std::string hash_of(const std::vector<Case>& cases) {
  std::vector<Point> scenes;
  for (const Case& one : cases) scenes.push_back({.key = write_scene({*one.scene, {}})});
  return plan_hash(scenes);
}

void must_differ(std::span<const Point> points) {
  std::set<std::string> seen;
  for (const Point& point : points) must_be_new(point.key, seen);
}

}  // namespace plumb
