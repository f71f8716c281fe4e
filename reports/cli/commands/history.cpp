#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "reports/cli/command_line.h"
#include "reports/history/commit.h"
#include "reports/history/snapshot.h"
#include "reports/history/store.h"
#include "reports/history/trends.h"
#include "reports/system/files.h"
#include "reports/writers/html.h"
#include "reports/writers/output.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/json_reader.h"
#include "scenarios/scene/nearest.h"

namespace plumb::commands::history {
namespace {

struct Options {
  std::string file = "plumb-history.sqlite";
  std::vector<std::string> reports;
  std::string commit, at;
  std::string lines;  // a file of JSON lines
  std::string metric, scenario, engine, since;
  std::string out = "out";
};

constexpr std::size_t largest_report = std::size_t{1} << 26;  // bytes

// The time of a commit, not of a clock, so that it is the same for everyone.
Commit commit_of(const Options& options) {
  auto commit = find_commit(options.commit);
  if (!commit && !options.commit.empty() && !options.at.empty()) commit = Commit{options.commit, ""};
  if (!commit) {
    throw std::invalid_argument(options.commit.empty()
                                    ? "there is no git commit here; give --commit and --at"
                                    : "there is no git commit \"" + options.commit + "\" here; give --at as well");
  }
  if (!options.at.empty()) commit->at = utc(options.at);
  return *commit;
}

int add(const Options& options) {
  const Commit commit = commit_of(options);
  std::vector<Snapshot> snapshots;
  for (const std::string& file : options.reports) {
    snapshots.push_back(snapshot_of_report(read_text(file, largest_report), file));
    snapshots.back().commit = commit.hash;
    snapshots.back().at = commit.at;
  }
  History history = History::to_add(options.file);
  for (const Snapshot& snapshot : snapshots) {
    const bool added = history.add(snapshot);
    fmt::print("{} {} of {} at {}\n", added ? "added" : "already there:", id_of(snapshot).substr(0, 12),
               snapshot.commit, snapshot.at);
  }
  return 0;
}

int list(const Options& options) {
  fmt::print("{}", text_of(History::of(options.file).heads()));
  return 0;
}

std::vector<Series> only(const Options& options, std::vector<Series> all) {
  std::erase_if(all, [&](const Series& series) {
    const auto& [scenario, variant, engine, dt] = series.subject;
    const bool of_case =
        options.scenario.empty() || options.scenario == scenario || options.scenario == scenario + ":" + variant;
    return !of_case || (!options.engine.empty() && options.engine != engine);
  });
  return all;
}

// A revision's time, a date or a time, or "7d": a week before the newest snapshot, as no clock is read. "": none.
std::string moment_of(const std::string& since, const std::vector<SnapshotHead>& heads) {
  if (since.empty()) return "";
  constexpr std::size_t most_digits = 3;
  const std::string digits = since.substr(0, since.size() - 1);
  const bool days = since.back() == 'd' && !digits.empty() && digits.size() <= most_digits &&
                    digits.find_first_not_of("0123456789") == digits.npos;
  if (days && !heads.empty()) return days_before(heads.back().at, std::stoi(digits));
  if (const auto commit = find_commit(since)) return commit->at;
  try {
    return utc(since);
  } catch (const std::invalid_argument&) {
    throw std::invalid_argument(
        fmt::format("--since: \"{}\" is neither a number of days (7d) nor a date (2026-11-21) nor a revision here",
                    printable(since)));
  }
}

int changes(const Options& options) {
  const History history = History::of(options.file);
  const auto heads = history.heads();
  const std::string since = moment_of(options.since, heads);
  fmt::print("{}", text_of(heads, trends_of(heads, history.series()), verdict_changes(history.verdicts()), since));
  return 0;
}

// The metric, by its name until 0.1 as well.
std::string metric_of(const std::string& name) {
  constexpr const char* old_name = "share_of_allowed";
  if (name != old_name) return name;
  fmt::print(stderr, "{} is called {} now; the old name will go\n", old_name, worst_ratio_metric);
  return worst_ratio_metric;
}

int trend(const Options& options) {
  const History history = History::of(options.file);
  const auto series = history.series(metric_of(options.metric));
  if (series.empty()) {
    std::set<std::string> metrics;
    for (const Series& one : history.series()) metrics.insert(one.metric);
    throw std::invalid_argument(unknown("metric", options.metric, std::vector(metrics.begin(), metrics.end())));
  }
  const auto heads = history.heads();
  const auto trends = trends_of(heads, only(options, series));
  if (trends.empty()) throw std::invalid_argument("there is no series with that metric, scenario and engine");
  fmt::print("{}", text_of(heads, trends));
  return 0;
}

int export_lines(const Options& options) {
  const History history = History::of(options.file);
  std::string lines;
  for (const SnapshotHead& head : history.heads()) lines += to_sealed_line(history.snapshot(head.id)) + "\n";
  NewFile file(options.lines);
  file.write_all(lines);
  fmt::print("{}\n", printable(file.put_in_place().string(), std::string::npos));
  return 0;
}

int import_lines(const Options& options) {
  std::ifstream lines(options.lines);
  if (!lines || std::filesystem::is_directory(options.lines)) {
    throw std::invalid_argument(options.lines + ": cannot be read");
  }
  std::vector<Snapshot> snapshots;
  for (std::string line; std::getline(lines, line);) {
    snapshots.push_back(snapshot_of_line(line, fmt::format("{}: line {}", options.lines, snapshots.size() + 1)));
  }
  History history = History::to_add(options.file);
  std::size_t added = 0;
  for (const Snapshot& snapshot : snapshots) added += history.add(snapshot);
  fmt::print("{} of {} snapshots added, {} already there\n", added, snapshots.size(), snapshots.size() - added);
  return 0;
}

int page(const Options& options) {
  const History history = History::of(options.file);
  const OutputFolder folder(options.out);
  std::string why_not;
  const auto text = fill_page(page_template(), nlohmann::ordered_json{{"study", history_document(history)}}, why_not);
  if (!text) throw std::invalid_argument("no history.html: " + why_not);
  for (const auto& place : folder.put({{"history.html", *text}}))
    fmt::print("{}\n", printable(place.string(), std::string::npos));
  return 0;
}

std::function<int()> attach(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  const auto chosen = std::make_shared<std::function<int()>>();
  app.require_subcommand(1);
  const auto word = [&](const char* name, const char* about, int (*function)(const Options&)) {
    CLI::App& added = *app.add_subcommand(name, about);
    added.add_option("--file", options->file, "The history")->capture_default_str()->type_name("FILE");
    added.callback([=] { *chosen = [=] { return function(*options); }; });
    return &added;
  };
  CLI::App* adding = word("add", "Add reports; those already there are not added again", add);
  adding->add_option("reports", options->reports, "report.json of plumb run or plumb report")
      ->required()
      ->type_name("REPORT");
  adding->add_option("--commit", options->commit, "Commit of the code that made them; default: HEAD")
      ->type_name("REVISION");
  adding->add_option("--at", options->at, "Time of the commit, 2026-11-21T09:06:10Z; default: from git")
      ->type_name("MOMENT");
  word("list", "All snapshots with their commits and numbers of verdicts", list);
  word("changes", "Changes of verdicts, numbers and times, by commit", changes)
      ->add_option("--since", options->since,
                   "Only in snapshots from then on: 7d (before the newest), 2026-11-21 or a revision; default: all")
      ->type_name("MOMENT");
  CLI::App* trending = word("trend", "A metric from commit to commit in every case and engine, and its changes", trend);
  trending->add_option("metric", options->metric, "As plumb list names it; worst_error_ratio or step_us")
      ->required()
      ->type_name("METRIC");
  trending->add_option("--scenario", options->scenario, "NAME or NAME:LABEL; default: all")->type_name("SCENARIO");
  trending->add_option("--engine", options->engine, "NAME[:key=value,...]; default: all")->type_name("ENGINE");
  word("export", "Write all snapshots as JSON lines, oldest first", export_lines)
      ->add_option("lines", options->lines, "The file to write")
      ->required()
      ->type_name("LINES");
  word("import", "Add exported snapshots", import_lines)
      ->add_option("lines", options->lines, "The file to read")
      ->required()
      ->type_name("LINES");
  word("page", "Write history.html", page)
      ->add_option("--out", options->out, "Its folder")
      ->capture_default_str()
      ->type_name("DIR");
  return [chosen] { return (*chosen)(); };
}

const Catalog<Command>::Entry entry{
    {.name = "history",
     .about = "Keep reports from commit to commit, and show what changes",
     .examples = "  plumb history add out/report.json                    for the commit that is checked out\n"
                 "  plumb history changes --since 7d                     what changed in a week, the newest first\n"
                 "  plumb history trend step_us --engine impulse         a metric from commit to commit\n"
                 "  plumb history export history.jsonl                   to take elsewhere: import\n",
     .attach = attach}};

}  // namespace
}  // namespace plumb::commands::history
