#include "reports/study/document.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/system/files.h"
#include "reports/writers/html.h"
#include "reports/writers/page.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr int document_format = 1;  // grows when a reader of the old one would be misled

void add_new(std::vector<std::string>& names, const Json& object) {
  for (const auto& [name, value] : object.items()) {
    if (value.is_structured() || std::find(names.begin(), names.end(), name) != names.end()) continue;
    names.push_back(name);
  }
}

std::string fields(const std::vector<std::string>& names, const Json& object) {
  std::string text;
  for (const std::string& name : names) {
    text += ',';
    const auto found = object.find(name);
    if (found == object.end() || found->is_null()) continue;
    text += found->is_string() ? csv_field(found->get<std::string>()) : csv_field(found->dump());
  }
  return text;
}

}  // namespace

Json document_of(const Study& study, const ResultsHead& head, const std::vector<PointResult>& results,
                 const Findings& found) {
  Json points = Json::array();
  Json times = Json::object();
  for (const PointResult& result : results) {
    points.push_back({{"key", result.key},
                      {"ending", name_of(result.ending)},
                      {"reason", result.reason},
                      {"values", result.row.values}});
    if (!result.row.times.empty()) times[result.key] = result.row.times;
  }
  Json timings = found.timings;
  timings["points"] = std::move(times);
  return {{"plumb", document_format},
          {"study", study.name},
          {"about", study.about},
          {"configuration", head.configuration},
          {"environment", head.environment},
          {"points", std::move(points)},
          {"findings", found.findings},
          {"timings", std::move(timings)}};
}

std::string csv_of(const std::vector<PointResult>& results) {
  std::vector<std::string> values;
  std::vector<std::string> times;
  for (const PointResult& result : results) {
    add_new(values, result.row.values);
    add_new(times, result.row.times);
  }
  std::string text = "key,ending,reason";
  for (const std::string& name : values) text += "," + csv_field(name);
  for (const std::string& name : times) text += "," + csv_field("time_" + name);
  text += "\n";
  for (const PointResult& result : results) {
    text += csv_field(result.key) + "," + name_of(result.ending) + "," + csv_field(result.reason) +
            fields(values, result.row.values) + fields(times, result.row.times) + "\n";
  }
  return text;
}

void write_study(const Study& study, const ResultsHead& head, const StudyPlan& plan,
                 const std::vector<PointResult>& results, const OutputFolder& folder) {
  const Findings found = plan.conclude(results);
  const Json document = document_of(study, head, results, found);
  const std::string stem = "study-" + study.name;
  std::vector<std::pair<std::string, std::string>> files{{stem + ".json", document.dump(1) + "\n"},
                                                         {stem + ".csv", csv_of(results)}};
  std::string why_not;
  if (auto page = fill_page(page_template(), Json{{"study", document}}, why_not)) {
    files.emplace_back(stem + ".html", std::move(*page));
  }
  const auto placed = folder.put(files);
  fmt::print("{}", found.summary);
  for (const auto& place : placed) fmt::print("{}\n", place.string());
  if (!why_not.empty()) fmt::print("No {}.html: {}.\n", stem, why_not);
}

}  // namespace plumb
