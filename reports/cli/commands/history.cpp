#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "reports/cli/command.h"
#include "reports/history/commit.h"
#include "reports/history/store.h"
#include "reports/history/trends.h"
#include "reports/system/files.h"
#include "reports/writers/html.h"
#include "reports/writers/output.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/nearest.h"

namespace plumb::commands::history {
namespace {

struct Asked {
  std::string file = "plumb-history.sqlite";
  std::vector<std::string> reports;
  std::string commit, at;
  std::string lines;  // a file of JSON lines
  std::string metric, scenario, engine;
  std::string out = "out";
};

constexpr std::size_t largest_report = std::size_t{1} << 26;  // bytes

// No clock is asked: when a commit was made is the same for everyone.
Commit commit_of(const Asked& asked) {
  auto commit = find_commit(asked.commit);
  if (!commit && !asked.commit.empty() && !asked.at.empty()) commit = Commit{asked.commit, ""};
  if (!commit) {
    throw std::invalid_argument(asked.commit.empty()
                                    ? "git knows no commit here; say --commit and --at"
                                    : "git knows no commit \"" + asked.commit + "\" here; say --at, too");
  }
  if (!asked.at.empty()) commit->at = utc(asked.at);
  return *commit;
}

int add(const Asked& asked) {
  const Commit commit = commit_of(asked);
  std::vector<Snapshot> snapshots;
  for (const std::string& file : asked.reports) {
    snapshots.push_back(snapshot_of_report(read_text(file, largest_report), file));
    snapshots.back().commit = commit.hash;
    snapshots.back().at = commit.at;
  }
  History history = History::to_add(asked.file);
  for (const Snapshot& snapshot : snapshots) {
    const bool added = history.add(snapshot);
    fmt::print("{} {} of {} at {}\n", added ? "added" : "was there:", id_of(snapshot).substr(0, 12), snapshot.commit,
               snapshot.at);
  }
  return 0;
}

int list(const Asked& asked) {
  fmt::print("{}", text_of(History::of(asked.file).heads()));
  return 0;
}

std::vector<Series> only(const Asked& asked, std::vector<Series> all) {
  std::erase_if(all, [&](const Series& series) {
    const auto& [scenario, variant, engine, dt] = series.subject;
    const bool of_case =
        asked.scenario.empty() || asked.scenario == scenario || asked.scenario == scenario + ":" + variant;
    return !of_case || (!asked.engine.empty() && asked.engine != engine);
  });
  return all;
}

int changes(const Asked& asked) {
  const History history = History::of(asked.file);
  const auto heads = history.heads();
  fmt::print("{}", text_of(heads, trends_of(heads, history.series()), verdict_changes(history.verdicts())));
  return 0;
}

int trend(const Asked& asked) {
  const History history = History::of(asked.file);
  const auto series = history.series(asked.metric);
  if (series.empty()) {
    std::set<std::string> metrics;
    for (const Series& one : history.series()) metrics.insert(one.metric);
    throw std::invalid_argument(unknown("metric", asked.metric, std::vector(metrics.begin(), metrics.end())));
  }
  const auto heads = history.heads();
  const auto trends = trends_of(heads, only(asked, series));
  if (trends.empty()) throw std::invalid_argument("no series is of that metric, scenario and engine");
  fmt::print("{}", text_of(heads, trends));
  return 0;
}

int export_lines(const Asked& asked) {
  const History history = History::of(asked.file);
  std::string lines;
  for (const SnapshotHead& head : history.heads()) lines += to_line(history.snapshot(head.id)) + "\n";
  NewFile file(asked.lines);
  if (!file.write(lines)) throw std::invalid_argument(asked.lines + ": cannot be written");
  fmt::print("{}\n", file.put_in_place().string());
  return 0;
}

int import_lines(const Asked& asked) {
  std::ifstream lines(asked.lines);
  if (!lines || std::filesystem::is_directory(asked.lines)) {
    throw std::invalid_argument(asked.lines + ": cannot be read");
  }
  std::vector<Snapshot> snapshots;
  for (std::string line; std::getline(lines, line);) {
    snapshots.push_back(snapshot_of_line(line, fmt::format("{}: line {}", asked.lines, snapshots.size() + 1)));
  }
  History history = History::to_add(asked.file);
  std::size_t added = 0;
  for (const Snapshot& snapshot : snapshots) added += history.add(snapshot);
  fmt::print("{} of {} snapshots were added, {} were there\n", added, snapshots.size(), snapshots.size() - added);
  return 0;
}

int page(const Asked& asked) {
  const History history = History::of(asked.file);
  const OutputFolder folder(asked.out);
  std::string why_not;
  const auto text = fill_page(page_template(), nlohmann::ordered_json{{"study", history_document(history)}}, why_not);
  if (!text) throw std::invalid_argument("no history.html: " + why_not);
  for (const auto& place : folder.put({{"history.html", *text}})) fmt::print("{}\n", place.string());
  return 0;
}

std::function<int()> attach(CLI::App& app) {
  const auto asked = std::make_shared<Asked>();
  const auto chosen = std::make_shared<std::function<int()>>();
  app.require_subcommand(1);
  const auto word = [&](const char* name, const char* about, int (*carry_out)(const Asked&)) {
    CLI::App& added = *app.add_subcommand(name, about);
    added.add_option("--file", asked->file, "The history")->capture_default_str()->type_name("FILE");
    added.callback([=] { *chosen = [=] { return carry_out(*asked); }; });
    return &added;
  };
  CLI::App* adding = word("add", "Add what reports say; what is there already is not added again", add);
  adding->add_option("reports", asked->reports, "report.json of plumb run or plumb report")
      ->required()
      ->type_name("REPORT");
  adding->add_option("--commit", asked->commit, "Of the code that made them; default: HEAD")->type_name("REVISION");
  adding->add_option("--at", asked->at, "Their moment, 2026-11-21T09:06:10Z; default: the commit's")
      ->type_name("MOMENT");
  word("list", "Every snapshot, with its commit and how many runs have which verdict", list);
  word("changes", "What changes where: verdicts, numbers and times", changes);
  CLI::App* course = word("trend", "The course of a metric in every case and engine, and its changes", trend);
  course->add_option("metric", asked->metric, "As plumb list names it; worst_error_ratio or step_us")
      ->required()
      ->type_name("METRIC");
  course->add_option("--scenario", asked->scenario, "NAME or NAME:LABEL; default: all")->type_name("SCENARIO");
  course->add_option("--engine", asked->engine, "NAME[:key=value,...]; default: all")->type_name("ENGINE");
  word("export", "Write all as JSON lines, oldest first", export_lines)
      ->add_option("lines", asked->lines, "The file to write")
      ->required()
      ->type_name("LINES");
  word("import", "Add what was exported", import_lines)
      ->add_option("lines", asked->lines, "The file to read")
      ->required()
      ->type_name("LINES");
  word("page", "Write history.html to look at", page)
      ->add_option("--out", asked->out, "Its folder")
      ->capture_default_str()
      ->type_name("DIR");
  return [chosen] { return (*chosen)(); };
}

const Catalog<Command>::Entry entry{
    {.name = "history",
     .about = "Keep what reports say from commit to commit, and tell where it changes",
     .examples = "  plumb history add out/report.json                    as of the commit that is checked out\n"
                 "  plumb history changes                                what changed, the newest first\n"
                 "  plumb history trend step_us --engine impulse         a metric from commit to commit\n"
                 "  plumb history export history.jsonl                   to take elsewhere: import\n",
     .attach = attach}};

}  // namespace
}  // namespace plumb::commands::history
