// What is kept of a report.json.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "reports/history/json_place.h"
#include "reports/history/snapshot.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr int known_format = 1;  // of report.json

// Nothing where nothing judged the run; NaN where it is off and nothing is allowed.
std::optional<double> share_of_allowed(const JsonPlace& run) {
  std::optional<double> worst;
  const auto see = [&](double share) {
    if (!worst || (!std::isnan(*worst) && !(share <= *worst))) worst = share;
  };
  for (const JsonPlace& check : run.at("truth").items()) {
    if (check.at("revealed").json() == false) continue;
    const double error = check.at("error").number_or_null();
    see(error == 0 ? 0 : error / check.at("tolerance").number_or_null());
  }
  for (const JsonPlace& law : run.at("invariants").items()) {
    if (law.at("standing").text() != "not revealed") see(law.at("ratio").number_or_null());
  }
  if (worst && !std::isfinite(*worst)) worst = std::numeric_limits<double>::quiet_NaN();
  return worst;
}

Answered answered_of(const JsonPlace& run) {
  Answered answered{.verdict = run.at("verdict").text()};
  for (const auto& [name, metric] : run.at("metrics").members()) {
    answered.metrics[name] = {metric.at("value").number_or_null(), metric.at("unit").text()};
  }
  if (const auto share = share_of_allowed(run)) answered.metrics["share_of_allowed"] = {*share, "1"};
  return answered;
}

std::string contender_of(const JsonPlace& place) {
  return label_of(place.at("engine").text(), place.at("method").text());
}

}  // namespace

Snapshot snapshot_of_report(const Json& json, const std::string& name) {
  const JsonPlace report(json, name);
  const JsonPlace format = report.at("plumb");
  if (format.json() != known_format) format.refuse("a report of format 1");
  Snapshot snapshot;
  for (const JsonPlace& word : report.at("command").items()) snapshot.command.push_back(word.text());
  for (const auto& [key, value] : report.at("environment").members()) snapshot.environment[key] = value.text();

  using Place = std::tuple<std::string, std::string, std::string>;
  const auto place_of = [](const JsonPlace& one) {
    return Place{one.at("scenario").text(), one.at("variant").text(), contender_of(one)};
  };
  std::map<Place, Answered*> timed;  // times name no step: each is of the one run in its place
  for (const JsonPlace& run : report.at("runs").items()) {
    const auto [scenario, variant, contender] = place_of(run);
    const auto [found, added] =
        snapshot.answers.emplace(Subject{scenario, variant, contender, run.at("dt").number()}, answered_of(run));
    if (!added) run.refuse("each run once");
    timed[{scenario, variant, contender}] = &found->second;
  }
  for (const JsonPlace& time : report.at("timings").at("steps").items()) {
    const auto run = timed.find(place_of(time));
    if (run == timed.end()) time.refuse("the time of one of the runs");
    if (time.at("step_us").json().is_null()) continue;
    run->second->time = {time.at("step_us").number(), time.at("step_us_low").number(), time.at("step_us_high").number(),
                         time.at("repetitions").count()};
  }
  return snapshot;
}

}  // namespace plumb
