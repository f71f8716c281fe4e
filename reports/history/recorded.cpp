// What is kept of a report.json.
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <tuple>

#include "reports/gate/words.h"
#include "reports/history/snapshot.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

constexpr int known_format = 1;  // of report.json, see writers/json.cpp

// Refuses a list whose entries lack any of these.
template <class Take>
void for_each_entry(const JsonReader& list, std::initializer_list<const char*> keys, Take take) {
  for (std::size_t i = 0; i < list.list(); ++i) {
    const JsonReader entry = list[i];
    for (const char* key : keys) entry.must_have(key);
    take(entry);
  }
}

// Nothing where nothing judged the run; NaN where it is off and nothing is allowed.
std::optional<double> share_of_allowed(const JsonReader& run) {
  std::optional<double> worst;
  const auto see = [&](double share) {
    if (!worst || (!std::isnan(*worst) && !(share <= *worst))) worst = share;
  };
  for_each_entry(run["truth"], {"reported", "error", "tolerance"}, [&](const JsonReader& check) {
    const double error = number_or_null(check["error"]);
    if (check["reported"].boolean()) see(error == 0 ? 0 : error / number_or_null(check["tolerance"]));
  });
  for_each_entry(run["invariants"], {"status", "ratio"}, [&](const JsonReader& law) {
    if (check_status_from(law["status"]) != CheckStatus::not_reported) see(number_or_null(law["ratio"]));
  });
  if (worst && !std::isfinite(*worst)) worst = std::numeric_limits<double>::quiet_NaN();
  return worst;
}

Answered answered_in_report(const JsonReader& run) {
  Answered answered{.verdict = name_of(verdict_from(run["verdict"]))};
  for_each_member(run["metrics"], [&](const std::string& name, const JsonReader& metric) {
    metric.object({"value", "unit"});
    answered.metrics[name] = {number_or_null(metric["value"]), any_text(metric["unit"])};
  });
  if (const auto share = share_of_allowed(run)) answered.metrics["share_of_allowed"] = {*share, "1"};
  return answered;
}

std::optional<StepTime> time_of(const JsonReader& time) {
  const StepTime found{number_or_null(time["step_us"]), number_or_null(time["step_us_low"]),
                       number_or_null(time["step_us_high"]), static_cast<int>(time["repetitions"].number({0, 1e9}))};
  if (!std::isfinite(found.median) || !std::isfinite(found.low) || !std::isfinite(found.high)) return std::nullopt;
  return found;
}

}  // namespace

Snapshot snapshot_of_report(const std::string& text, const std::string& name) {
  const nlohmann::json json = parse_json(text, name);
  const JsonReader report(json, name);
  report.must_have("plumb");
  report["plumb"].number({known_format, known_format});
  for (const char* key : {"command", "environment", "runs", "timings"}) report.must_have(key);
  Snapshot snapshot{.command = words_from(report["command"]), .environment = texts_from(report["environment"])};

  using Place = std::tuple<std::string, std::string, std::string>;
  const auto place_of = [](const JsonReader& one) {
    return Place{any_text(one["scenario"]), any_text(one["variant"]),
                 label_of(any_text(one["engine"]), any_text(one["method"]))};
  };
  std::map<Place, Answered*> timed;  // times name no step: each is of the one run in its place
  for_each_entry(report["runs"],
                 {"scenario", "variant", "engine", "method", "dt", "verdict", "metrics", "truth", "invariants"},
                 [&](const JsonReader& run) {
                   const Place place = place_of(run);
                   const auto& [scenario, variant, engine] = place;
                   const Subject subject{scenario, variant, engine, run["dt"].number({0, 1, "s"})};
                   const auto [found, added] = snapshot.answers.emplace(subject, answered_in_report(run));
                   if (!added) run.refuse("is there twice");
                   timed[place] = &found->second;
                 });
  const JsonReader timings = report["timings"];
  timings.must_have("steps");
  for_each_entry(timings["steps"],
                 {"scenario", "variant", "engine", "method", "step_us", "step_us_low", "step_us_high", "repetitions"},
                 [&](const JsonReader& time) {
                   const auto run = timed.find(place_of(time));
                   if (run == timed.end()) time.refuse("is of none of the runs");
                   run->second->time = time_of(time);
                 });
  return snapshot;
}

}  // namespace plumb
