#include "reports/study/brief.h"

#include <CLI/App.hpp>
#include <map>
#include <stdexcept>

#include "reports/study/document.h"
#include "reports/study/runner.h"
#include "reports/system/environment.h"

namespace plumb {
namespace {

nlohmann::ordered_json configuration_of(const Study& study) {
  CLI::App app;
  const auto configuration = study.attach(app);
  std::vector<std::string> words(study.brief->rbegin(), study.brief->rend());  // as CLI11 takes them
  try {
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    throw std::logic_error("study " + study.name + ": its short form: " + error.what());
  }
  return configuration();
}

}  // namespace

std::string brief_command(const Study& study) {
  std::string command = "plumb study " + study.name;
  for (const std::string& word : *study.brief) command += " " + word;
  return command;
}

nlohmann::ordered_json brief_document(
    const Study& study, int jobs,
    const std::function<void(const std::string& key, std::size_t done, std::size_t of)>& tell) {
  const nlohmann::ordered_json configuration = configuration_of(study);
  const StudyPlan plan = study.plan(configuration);
  std::map<std::string, PointResult> known;
  execute(units_of(plan.points), {.jobs = jobs}, [&](std::span<const PointResult> results) {
    for (const PointResult& result : results) known.emplace(result.key, result);
    tell(results.back().key, known.size(), plan.points.size());
  });
  std::vector<PointResult> results;
  for (const Point& point : plan.points) results.push_back(known.at(point.key));
  const ResultsHead head{.study = study.name,
                         .configuration = configuration,
                         .plan = plan_hash(plan.points),
                         .shard = {},
                         .points = results.size(),
                         .environment = environment()};
  nlohmann::ordered_json document = document_of(study, head, results, plan.conclude(results));
  document["command"] = brief_command(study);
  return document;
}

}  // namespace plumb
