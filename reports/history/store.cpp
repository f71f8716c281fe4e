#include "reports/history/store.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

// The number of the row with these values, which is inserted if it is missing.
template <class... Values>
std::int64_t number_of(Statement& add, Statement& find, const Values&... values) {
  add.with(values...).next();
  find.with(values...).next();
  return find.integer(0);
}

}  // namespace

bool History::add(const Snapshot& snapshot) {
  const std::string id = id_of(snapshot);
  Transaction transaction(database_);
  Statement known = database_.prepare("SELECT 1 FROM snapshots WHERE id = ?");
  if (known.with(id).next()) return false;

  database_.prepare("INSERT INTO snapshots (id, commit_hash, at, command, environment) VALUES (?, ?, ?, ?, ?)")
      .with(id, snapshot.commit, snapshot.at, Json(snapshot.command).dump(), Json(snapshot.environment).dump())
      .next();
  const std::int64_t number = database_.last_row();
  Statement add_subject =
      database_.prepare("INSERT OR IGNORE INTO subjects (scenario, variant, engine, dt) VALUES (?, ?, ?, ?)");
  Statement find_subject =
      database_.prepare("SELECT number FROM subjects WHERE scenario = ? AND variant = ? AND engine = ? AND dt = ?");
  Statement add_series = database_.prepare("INSERT OR IGNORE INTO series (subject, metric, unit) VALUES (?, ?, ?)");
  Statement find_series = database_.prepare("SELECT number FROM series WHERE subject = ? AND metric = ? AND unit = ?");
  Statement add_point = database_.prepare("INSERT INTO points VALUES (?, ?, ?)");
  Statement add_verdict = database_.prepare("INSERT INTO verdicts (subject, snapshot, verdict) VALUES (?, ?, ?)");
  Statement add_timed = database_.prepare("INSERT INTO verdicts VALUES (?, ?, ?, ?, ?, ?, ?)");
  for (const auto& [key, run] : snapshot.runs) {
    const auto subject = number_of(add_subject, find_subject, key.scenario, key.variant, key.engine, key.dt);
    if (const auto& time = run.time) {
      add_timed.with(subject, number, run.verdict, time->median, time->low, time->high, time->repetitions).next();
    } else {
      add_verdict.with(subject, number, run.verdict).next();
    }
    for (const auto& [metric, measured] : run.metrics) {
      add_point.with(number_of(add_series, find_series, subject, metric, measured.unit), number, measured.value).next();
    }
  }
  transaction.commit();
  return true;
}

std::vector<SnapshotHead> History::heads() const {
  std::vector<SnapshotHead> all;
  Statement snapshots = database_.prepare("SELECT id, commit_hash, at, environment FROM snapshots ORDER BY at, id");
  while (snapshots.next()) {
    all.push_back({.id = snapshots.text(0),
                   .commit = snapshots.text(1),
                   .at = snapshots.text(2),
                   .environment = parse_environment(database_, snapshots.text(3))});
  }
  const auto index_of = index_of_row();
  Statement verdicts = database_.prepare("SELECT snapshot, verdict, count(*) FROM verdicts GROUP BY snapshot, verdict");
  while (verdicts.next()) {
    all[index_of(verdicts.integer(0))].verdicts[verdicts.text(1)] = static_cast<int>(verdicts.integer(2));
  }
  return all;
}

Snapshot History::snapshot(const std::string& id) const {
  Statement found = database_.prepare("SELECT number FROM snapshots WHERE id = ?");
  if (!found.with(id).next()) database_.refuse(fmt::format("there is no snapshot {}", id));
  Snapshot snapshot = read_snapshot(database_, found.integer(0));
  if (id_of(snapshot) != id)
    database_.refuse(fmt::format("is damaged: snapshot {} is not what was added", id.substr(0, 12)));
  return snapshot;
}

std::function<std::size_t(std::int64_t)> History::index_of_row() const {
  std::map<std::int64_t, std::size_t> all;
  Statement numbers = database_.prepare("SELECT number FROM snapshots ORDER BY at, id");
  while (numbers.next()) all.emplace(numbers.integer(0), all.size());
  return [this, all](std::int64_t number) {
    const auto found = all.find(number);
    if (found == all.end()) database_.refuse("is damaged: a snapshot is missing");
    return found->second;
  };
}

std::vector<Series> History::series(const std::string& metric) const {
  const auto index_of = index_of_row();
  std::map<std::tuple<Subject, std::string, std::string>, std::vector<Series::Value>> found;
  Statement points = database_.prepare(
      "SELECT scenario, variant, engine, dt, metric, unit, snapshot, value FROM points "
      "JOIN series ON series = series.number JOIN subjects ON subject = subjects.number WHERE ? IN ('', metric)");
  points.with(metric);
  while (points.next()) {
    const double value = points.number(7);
    found[{subject_at(points, 0), points.text(4), points.text(5)}].push_back(
        {index_of(points.integer(6)), value, value, value});
  }
  Statement times = database_.prepare(
      "SELECT scenario, variant, engine, dt, snapshot, step_us, step_us_low, step_us_high "
      "FROM verdicts JOIN subjects ON subject = number WHERE step_us IS NOT NULL AND ? IN ('', 'step_us')");
  times.with(metric);
  while (times.next()) {
    found[{subject_at(times, 0), step_time, "us"}].push_back(
        {index_of(times.integer(4)), times.number(5), times.number(6), times.number(7)});
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
  Statement rows = database_.prepare(
      "SELECT scenario, variant, engine, dt, verdict, snapshots.number FROM verdicts "
      "JOIN subjects ON subject = subjects.number JOIN snapshots ON snapshot = snapshots.number "
      "ORDER BY scenario, variant, engine, dt, at, id");
  const auto index_of = index_of_row();
  while (rows.next()) {
    Subject subject = subject_at(rows, 0);
    if (all.empty() || all.back().subject != subject) all.push_back({std::move(subject), {}});
    all.back().values.push_back({index_of(rows.integer(5)), rows.text(4)});
  }
  return all;
}

}  // namespace plumb
