#include "reports/history/snapshot.h"

#include <fmt/format.h>

#include <cstddef>
#include <limits>

#include "reports/gate/words.h"
#include "reports/history/moment.h"
#include "reports/history/sha256.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr int line_format = 1;  // of a line; grows when a reader of the old one would be misled

// A negative zero is a zero, in a database as well.
double plain(double value) { return value + 0.0; }

Json json_of(const Subject& subject, const Answered& answered) {
  Json json{{"scenario", subject.scenario}, {"variant", subject.variant},
            {"contender", subject.engine},  {"dt", subject.dt},
            {"verdict", answered.verdict},  {"metrics", Json::object()}};
  for (const auto& [name, measured] : answered.metrics) {
    json["metrics"][name] = {plain(measured.value), measured.unit};
  }
  if (answered.time) {
    const auto& [median, low, high, repetitions] = *answered.time;
    json["step_us"] = {plain(median), plain(low), plain(high), repetitions};
  }
  return json;
}

constexpr double most = std::numeric_limits<double>::max();

// One of the numbers in a list of so many.
double number_in(const JsonReader& list, std::size_t place, std::size_t many) {
  if (list.list() != many) list.expected(fmt::format("a list of {}", many));
  return list[place].number({-most, most});
}

Answered answered_of(const JsonReader& from) {
  Answered answered{.verdict = any_text(from["verdict"])};
  for_each_member(from["metrics"], [&](const std::string& name, const JsonReader& metric) {
    if (metric.list() != 2) metric.expected("a value and a unit");
    answered.metrics[name] = {number_or_null(metric[std::size_t{0}]), any_text(metric[std::size_t{1}])};
  });
  if (from.has("step_us")) {
    const JsonReader time = from["step_us"];
    answered.time = {number_in(time, 0, 4), number_in(time, 1, 4), number_in(time, 2, 4),
                     static_cast<int>(time[std::size_t{3}].number({0, 1e9}))};
  }
  return answered;
}

}  // namespace

std::string to_line(const Snapshot& snapshot) {
  Json json{{"plumb_history", line_format},
            {"commit", snapshot.commit},
            {"at", snapshot.at},
            {"command", snapshot.command},
            {"environment", Json(snapshot.environment)},
            {"answers", Json::array()}};
  for (const auto& [subject, answered] : snapshot.answers) json["answers"].push_back(json_of(subject, answered));
  // What is no UTF-8 is not to be lost in an error: it can only come from a damaged history, which its hash tells.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Snapshot snapshot_of_line(const std::string& line, const std::string& name) {
  const nlohmann::json json = parse_json(line, name);
  const JsonReader whole(json, name);
  whole.must_have("plumb_history");
  whole["plumb_history"].number({line_format, line_format});
  whole.object({"plumb_history", "commit", "at", "command", "environment", "answers"});
  Snapshot snapshot{.commit = any_text(whole["commit"]),
                    .at = any_text(whole["at"]),
                    .command = words_from(whole["command"]),
                    .environment = texts_from(whole["environment"])};
  if (utc(snapshot.at) != snapshot.at) whole["at"].expected("a moment in UTC, " + utc(snapshot.at));
  const JsonReader answers = whole["answers"];
  for (std::size_t i = 0; i < answers.list(); ++i) {
    const JsonReader one = answers[i];
    one.object({"scenario", "variant", "contender", "dt", "verdict", "metrics"}, {"step_us"});
    const Subject subject{any_text(one["scenario"]), any_text(one["variant"]), any_text(one["contender"]),
                          plain(one["dt"].number({0, most, "s"}))};
    if (!snapshot.answers.emplace(subject, answered_of(one)).second) one.refuse("is there twice");
  }
  return snapshot;
}

std::vector<std::string> words_from(const JsonReader& list) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < list.list(); ++i) words.push_back(any_text(list[i]));
  return words;
}

std::string id_of(const Snapshot& snapshot) { return sha256(to_line(snapshot)); }

}  // namespace plumb
