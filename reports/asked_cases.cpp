#include "reports/asked_cases.h"

#include <set>
#include <stdexcept>
#include <utility>

#include "reports/cli.h"
#include "reports/study/results_file.h"
#include "scenarios/scene_json.h"

namespace plumb {

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

std::string hash_of(const std::vector<Case>& cases) {
  std::vector<Point> scenes;
  for (const Case& one : cases) scenes.push_back({.key = write_scene({*one.scene, {}})});
  return plan_hash(scenes);
}

void must_differ(std::span<const Point> points) {
  std::set<std::string> seen;
  for (const Point& point : points) {
    if (!seen.insert(point.key).second) throw std::invalid_argument("\"" + point.key + "\" is asked for twice");
  }
}

}  // namespace plumb
