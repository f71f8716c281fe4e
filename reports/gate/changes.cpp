#include "reports/gate/changes.h"

#include <filesystem>

#include "reports/gate/baseline_json.h"
#include "reports/gate/compare.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json of(const Regression& one) {
  return {{"scenario", one.run.scenario},
          {"variant", one.run.variant},
          {"engine", one.run.engine},
          {"method", one.run.method},
          {"metric", one.metric},
          {"before", one.before},
          {"now", one.now},
          {"tolerance", one.tolerance},
          {"why", one.why},
          {"change", name_of(one.change)}};
}

template <class Map>
void keep_shared(Map& a, Map& b) {
  std::erase_if(a, [&](const auto& entry) { return b.count(entry.first) == 0; });
  std::erase_if(b, [&](const auto& entry) { return a.count(entry.first) == 0; });
}

}  // namespace

std::optional<Json> changes_since(const std::string& file, const Report& report) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  Baseline before = read_baseline(file), now = baseline_of(report);
  if (before.dt != now.dt) return std::nullopt;
  keep_shared(before.runs, now.runs);
  keep_shared(before.engines, now.engines);  // an engine that one of the two does not have is no other engine
  const GateResult result = compare(before, now);
  Json regressions = Json::array();
  for (const Regression& one : result.regressions) regressions.push_back(of(one));
  return Json{{"plumb", 2},
              {"study", "baseline"},
              {"about", "Against what was accepted"},
              {"configuration", {{"baseline", std::filesystem::path(file).filename().string()}}},
              {"environment", report.environment},
              {"results", Json::array()},
              {"findings",
               {{"verdict", result.verdict},
                {"notes", result.notes},
                {"runs", result.runs.size()},
                {"regressions", regressions}}},
              {"timings", {{"results", Json::object()}}}};
}

}  // namespace plumb
