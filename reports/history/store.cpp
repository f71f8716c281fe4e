#include "reports/history/store.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "reports/gate/words.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Subject subject_of(const Statement& row, int column) {
  return {row.text(column), row.text(column + 1), row.text(column + 2), row.number(column + 3)};
}

// Number of the row that has these values, added where it was missing.
template <class... Values>
std::int64_t number_of(Statement& add, Statement& find, const Values&... values) {
  add.with(values...).next();
  find.with(values...).next();
  return find.whole(0);
}

}  // namespace

bool History::add(const Snapshot& snapshot) {
  const std::string id = id_of(snapshot);
  Transaction all(database_);
  Statement known = database_.ask("SELECT 1 FROM snapshots WHERE id = ?");
  if (known.with(id).next()) return false;

  database_.ask("INSERT INTO snapshots (id, commit_hash, at, command, environment) VALUES (?, ?, ?, ?, ?)")
      .with(id, snapshot.commit, snapshot.at, Json(snapshot.command).dump(), Json(snapshot.environment).dump())
      .next();
  const std::int64_t number = database_.last_row();
  Statement add_subject =
      database_.ask("INSERT OR IGNORE INTO subjects (scenario, variant, contender, dt) VALUES (?, ?, ?, ?)");
  Statement find_subject =
      database_.ask("SELECT number FROM subjects WHERE scenario = ? AND variant = ? AND contender = ? AND dt = ?");
  Statement add_series = database_.ask("INSERT OR IGNORE INTO series (subject, metric, unit) VALUES (?, ?, ?)");
  Statement find_series = database_.ask("SELECT number FROM series WHERE subject = ? AND metric = ? AND unit = ?");
  Statement add_point = database_.ask("INSERT INTO points VALUES (?, ?, ?)");
  Statement add_verdict = database_.ask("INSERT INTO verdicts (subject, snapshot, verdict) VALUES (?, ?, ?)");
  Statement add_timed = database_.ask("INSERT INTO verdicts VALUES (?, ?, ?, ?, ?, ?, ?)");
  for (const auto& [who, answered] : snapshot.answers) {
    const auto subject = number_of(add_subject, find_subject, who.scenario, who.variant, who.engine, who.dt);
    if (const auto& time = answered.time) {
      add_timed.with(subject, number, answered.verdict, time->median, time->low, time->high, time->repetitions).next();
    } else {
      add_verdict.with(subject, number, answered.verdict).next();
    }
    for (const auto& [metric, measured] : answered.metrics) {
      add_point.with(number_of(add_series, find_series, subject, metric, measured.unit), number, measured.value).next();
    }
  }
  all.commit();
  return true;
}

std::vector<SnapshotHead> History::heads() const {
  std::vector<SnapshotHead> all;
  Statement snapshots = database_.ask("SELECT id, commit_hash, at, environment FROM snapshots ORDER BY at, id");
  while (snapshots.next()) {
    all.push_back({.id = snapshots.text(0),
                   .commit = snapshots.text(1),
                   .at = snapshots.text(2),
                   .environment = texts_of(snapshots.text(3))});
  }
  const auto place_of = places();
  Statement verdicts = database_.ask("SELECT snapshot, verdict, count(*) FROM verdicts GROUP BY snapshot, verdict");
  while (verdicts.next()) {
    all[place_of(verdicts.whole(0))].verdicts[verdicts.text(1)] = static_cast<int>(verdicts.whole(2));
  }
  return all;
}

Snapshot History::snapshot(const std::string& id) const {
  Statement found = database_.ask("SELECT commit_hash, at, command, environment, number FROM snapshots WHERE id = ?");
  if (!found.with(id).next()) database_.refuse(fmt::format("there is no snapshot {}", id));
  Snapshot snapshot{.commit = found.text(0), .at = found.text(1), .environment = texts_of(found.text(3))};
  const std::string name = damaged();
  const nlohmann::json command = parse_json(found.text(2), name);
  snapshot.command = words_from(JsonReader(command, name));
  const std::int64_t number = found.whole(4);
  Statement verdicts = database_.ask(
      "SELECT scenario, variant, contender, dt, verdict, step_us, step_us_low, step_us_high, repetitions "
      "FROM verdicts JOIN subjects ON subject = number WHERE snapshot = ?");
  verdicts.with(number);
  while (verdicts.next()) {
    Answered& answered = snapshot.answers[subject_of(verdicts, 0)];
    answered.verdict = verdicts.text(4);
    if (verdicts.null(5)) continue;
    answered.time = {verdicts.number(5), verdicts.number(6), verdicts.number(7), static_cast<int>(verdicts.whole(8))};
  }
  Statement points = database_.ask(
      "SELECT scenario, variant, contender, dt, metric, unit, value FROM points "
      "JOIN series ON series = series.number JOIN subjects ON subject = subjects.number WHERE snapshot = ?");
  points.with(number);
  while (points.next()) {
    snapshot.answers[subject_of(points, 0)].metrics[points.text(4)] = {points.number(6), points.text(5)};
  }
  if (id_of(snapshot) != id)
    database_.refuse(fmt::format("is damaged: snapshot {} is not what was added", id.substr(0, 12)));
  return snapshot;
}

std::string History::damaged() const { return database_.path().string() + ": is damaged"; }

std::map<std::string, std::string> History::texts_of(const std::string& text) const {
  const std::string name = damaged();
  const nlohmann::json json = parse_json(text, name);
  return texts_from(JsonReader(json, name));
}

std::function<std::size_t(std::int64_t)> History::places() const {
  std::map<std::int64_t, std::size_t> all;
  Statement numbers = database_.ask("SELECT number FROM snapshots ORDER BY at, id");
  while (numbers.next()) all.emplace(numbers.whole(0), all.size());
  return [this, all](std::int64_t number) {
    const auto found = all.find(number);
    if (found == all.end()) throw std::invalid_argument(damaged() + ": a snapshot is missing");
    return found->second;
  };
}

std::vector<Series> History::series(const std::string& metric) const {
  const auto place_of = places();
  std::map<std::tuple<Subject, std::string, std::string>, std::vector<Series::Value>> found;
  Statement points = database_.ask(
      "SELECT scenario, variant, contender, dt, metric, unit, snapshot, value FROM points "
      "JOIN series ON series = series.number JOIN subjects ON subject = subjects.number WHERE ? IN ('', metric)");
  points.with(metric);
  while (points.next()) {
    const double value = points.number(7);
    found[{subject_of(points, 0), points.text(4), points.text(5)}].push_back(
        {place_of(points.whole(6)), value, value, value});
  }
  Statement times = database_.ask(
      "SELECT scenario, variant, contender, dt, snapshot, step_us, step_us_low, step_us_high "
      "FROM verdicts JOIN subjects ON subject = number WHERE step_us IS NOT NULL AND ? IN ('', 'step_us')");
  times.with(metric);
  while (times.next()) {
    found[{subject_of(times, 0), step_time, "us"}].push_back(
        {place_of(times.whole(4)), times.number(5), times.number(6), times.number(7)});
  }
  std::vector<Series> all;
  for (auto& [name, values] : found) {
    std::sort(values.begin(), values.end(),
              [](const Series::Value& a, const Series::Value& b) { return a.snapshot < b.snapshot; });
    all.push_back({std::get<0>(name), std::get<1>(name), std::get<2>(name), std::move(values)});
  }
  return all;
}

std::vector<VerdictSeries> History::verdicts() const {
  std::vector<VerdictSeries> all;
  Statement rows = database_.ask(
      "SELECT scenario, variant, contender, dt, verdict, snapshots.number FROM verdicts "
      "JOIN subjects ON subject = subjects.number JOIN snapshots ON snapshot = snapshots.number "
      "ORDER BY scenario, variant, contender, dt, at, id");
  const auto place_of = places();
  while (rows.next()) {
    Subject subject = subject_of(rows, 0);
    if (all.empty() || all.back().subject != subject) all.push_back({std::move(subject), {}});
    all.back().values.push_back({place_of(rows.whole(5)), rows.text(4)});
  }
  return all;
}

}  // namespace plumb
