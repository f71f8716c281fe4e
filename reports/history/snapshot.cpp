#include "reports/history/snapshot.h"

#include <fmt/format.h>

#include <stdexcept>

#include "reports/history/json_place.h"
#include "reports/history/moment.h"
#include "reports/history/sha256.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;  // of a line; grows when a reader of the old one would be misled

// A negative zero is a zero, in a database as well.
double plain(double value) { return value + 0.0; }

Json json_of(const Subject& subject, const Answered& answered) {
  Json json{{"scenario", subject.scenario},   {"variant", subject.variant},
            {"contender", subject.contender}, {"dt", subject.dt},
            {"verdict", answered.verdict},    {"metrics", Json::object()}};
  for (const auto& [name, measured] : answered.metrics) {
    json["metrics"][name] = {plain(measured.value), measured.unit};
  }
  if (answered.time) {
    const auto& [median, low, high, repetitions] = *answered.time;
    json["step_us"] = {plain(median), plain(low), plain(high), repetitions};
  }
  return json;
}

std::vector<JsonPlace> several(const JsonPlace& place, std::size_t many) {
  auto items = place.items();
  if (items.size() != many) place.refuse(fmt::format("a list of {}", many));
  return items;
}

Answered answered_of(const JsonPlace& place) {
  Answered answered{.verdict = place.at("verdict").text()};
  for (const auto& [name, metric] : place.at("metrics").members()) {
    const auto pair = several(metric, 2);
    answered.metrics[name] = {pair[0].number_or_null(), pair[1].text()};
  }
  if (place.has("step_us")) {
    const auto four = several(place.at("step_us"), 4);
    answered.time = {four[0].number(), four[1].number(), four[2].number(), four[3].count()};
  }
  return answered;
}

}  // namespace

std::string to_line(const Snapshot& snapshot) {
  Json json{{"plumb_history", format},
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
  const Json json = parse_json(line, name);
  const JsonPlace whole(json, name);
  if (whole.at("plumb_history").json() != format) whole.at("plumb_history").refuse(fmt::format("format {}", format));
  Snapshot snapshot{.commit = whole.at("commit").text(), .at = whole.at("at").text()};
  if (utc(snapshot.at) != snapshot.at) whole.at("at").refuse("a moment in UTC, " + utc(snapshot.at));
  for (const JsonPlace& word : whole.at("command").items()) snapshot.command.push_back(word.text());
  for (const auto& [key, value] : whole.at("environment").members()) snapshot.environment[key] = value.text();
  for (const JsonPlace& one : whole.at("answers").items()) {
    const Subject subject{one.at("scenario").text(), one.at("variant").text(), one.at("contender").text(),
                          plain(one.at("dt").number())};
    if (!snapshot.answers.emplace(subject, answered_of(one)).second) one.refuse("each answer once");
  }
  return snapshot;
}

std::string id_of(const Snapshot& snapshot) { return sha256(to_line(snapshot)); }

}  // namespace plumb
