#include "reports/study/conduct.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "reference/programs/line_process.h"
#include "reports/study/document.h"
#include "reports/study/results_file.h"
#include "reports/study/runner.h"
#include "reports/system/clock.h"
#include "reports/system/command_options.h"
#include "reports/system/environment.h"
#include "reports/system/terminal.h"
#include "reports/writers/output.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr int interrupted_exit = 130;  // what a shell returns for Ctrl-C

Shard shard_of(const StudyOptions& options) {
  if (!options.shard.empty()) return parse_shard(options.shard);
  return slurm_shard([](const char* name) { return std::getenv(name); }).value_or(Shard{});
}

std::string file_name(const Study& study, const Shard& shard) {
  return shard.whole() ? fmt::format("study-{}.jsonl", study.name)
                       : fmt::format("study-{}-{}-of-{}.jsonl", study.name, shard.k, shard.n);
}

// Results of an earlier run that this one continues; nullopt to start from nothing.
std::optional<StoredResults> results_to_resume(const fs::path& path, const ResultsHead& head,
                                               const StudyOptions& options) {
  if (options.fresh || !fs::exists(path)) return std::nullopt;
  StoredResults stored = read_results(path);
  if (!options.resume) {
    if (stored.results.size() >= stored.head.jobs) return std::nullopt;
    throw std::invalid_argument(
        fmt::format("{} holds {} of {} results of an interrupted study: --resume continues it, --fresh starts over",
                    path.string(), stored.results.size(), stored.head.jobs));
  }
  std::string difference = stored.head.difference_from(head);
  if (difference.empty() && stored.head.shard != head.shard) {
    difference = fmt::format("shard {}, not {}", stored.head.shard.name(), head.shard.name());
  }
  if (!difference.empty()) {
    throw std::invalid_argument(
        fmt::format("{} has {}: choose another --out, or start over with --fresh", path.string(), difference));
  }
  return stored;
}

std::string duration_text(double seconds) {
  const auto s = static_cast<long>(std::lround(seconds));
  if (s < 100) return fmt::format("{} s", s);
  return s < 6000 ? fmt::format("{} min {} s", s / 60, s % 60) : fmt::format("{} h {} min", s / 3600, s / 60 % 60);
}

class StudyProgress {
 public:
  /// `time_left`: s until no further job starts; infinite if all do.
  StudyProgress(std::string study, std::size_t resumed, std::size_t all, std::function<double()> time_left)
      : study_(std::move(study)), resumed_(resumed), done_(resumed), all_(all), time_left_(std::move(time_left)) {
    show("");
  }

  void add(std::span<const JobResult> results) {
    done_ += results.size();
    show(results.back().key);
  }

 private:
  void show(const std::string& last) const {
    const double spent = start_.seconds();
    const double each = spent / static_cast<double>(std::max<std::size_t>(done_ - resumed_, 1));
    const double of_all = each * static_cast<double>(all_ - done_);
    const double until = std::max(time_left_(), 0.0);
    const std::string done = until < of_all ? fmt::format("[{}]", done_) : fmt::format("[{}/{}]", done_, all_);
    const std::string left = done_ == resumed_ ? "" : duration_text(std::min(of_all, until)) + " left; last ";
    line_.show(fmt::format("{} {} {}{}", study_, done, left, last));
  }

  std::string study_;
  std::size_t resumed_, done_, all_;
  std::function<double()> time_left_;
  Stopwatch start_;
  ProgressLine line_{ProgressLine::Kind::long_run};
};

// The jobs up to the first without a result: all, unless the time was up. Jobs start in the plan's order, so they are
// those that a shorter plan would have.
std::span<const Job> jobs_done(const StudyPlan& plan, const std::map<std::string, JobResult>& known) {
  const auto end = std::ranges::find_if(plan.jobs, [&](const Job& one) { return !known.contains(one.key); });
  return {plan.jobs.begin(), end};
}

// Says which jobs ran out of time or memory, so that the study lacks their results; returns whether any did.
bool warn_about_limits(const std::vector<JobResult>& results, const StudyOptions& options) {
  const auto ended = [&](Ending ending) {
    return std::ranges::count_if(results, [ending](const JobResult& one) { return one.ending == ending; });
  };
  const auto late = ended(Ending::timed_out);
  const auto large = ended(Ending::out_of_memory);
  if (late > 0) {
    fmt::print(stderr, "{} of {} jobs took more than {} s, and the study does not know their results: --time-limit\n",
               late, results.size(), options.seconds);
  }
  if (large > 0) {
    fmt::print(stderr,
               "{} of {} jobs took more than {} MiB, and the study does not know their results: --memory-limit\n",
               large, results.size(), options.mebibytes);
  }
  return late + large > 0;
}

nlohmann::ordered_json summary_configuration(const Study& study, const std::vector<std::string>& options) {
  std::function<nlohmann::ordered_json()> configuration;
  try {
    read_words(options, [&](CLI::App& app) { configuration = study.attach(app); });
  } catch (const std::invalid_argument& error) {
    throw std::logic_error("study " + study.name + ": its summary: " + error.what());
  }
  return configuration();
}

std::string command_of(const Study& study, const std::vector<std::string>& options) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:=,%+@";
  std::string command = "plumb study " + study.name;
  for (const std::string& word : options) {
    const bool is_plain = word.find_first_not_of(plain) == std::string::npos;
    command += " " + (is_plain ? word : quoted_for_shell(word));
  }
  return command;
}

}  // namespace

void StudyOptions::attach_to(CLI::App& app) {
  CommandOptions add(app);
  add.add("--out", "DIR", out, "Folder for the results, study-NAME.json, .csv and .html");
  add.add("--jobs", "N", parallel, 1, 1024,
          "Jobs that run at the same time; timed jobs have the machine to themselves");
  add.flag("--resume", resume, "Continue an interrupted run from its results in the folder, if there are any");
  add.flag("--fresh", fresh, "Start over and replace earlier results");
  add.add("--shard", "k/n", shard, "Only part k of n, for `plumb merge`. Default: the task of a Slurm array, or all");
  add.add("--time-limit", "S", seconds, 0.001, 1e7, "Seconds that a job may take");
  add.add("--memory-limit", "MIB", mebibytes, 16, 1e9, "MiB of memory that a job may take");
}

int conduct(const Study& study, const nlohmann::ordered_json& configuration, const StudyOptions& options) {
  if (options.resume && options.fresh) throw std::invalid_argument("--resume and --fresh contradict each other");
  const StudyPlan plan = study.plan(configuration);
  ResultsHead head{.study = study.name,
                   .configuration = configuration,
                   .plan = plan_hash(plan.jobs),
                   .shard = shard_of(options),
                   .environment = environment()};
  const auto own_units = units_in(head.shard, units_of(plan.jobs));
  for (const std::span<const Job> unit : own_units) head.jobs += unit.size();
  const OutputFolder folder(options.out);
  const fs::path path = folder.path() / file_name(study, head.shard);
  const std::optional<StoredResults> stored = results_to_resume(path, head, options);
  std::map<std::string, JobResult> known;
  if (stored) known = stored->results;

  ResultsFile file = stored ? ResultsFile::append(path, *stored) : ResultsFile::create(path, head);
  const std::vector<std::vector<Job>> left = units_left(own_units, known);
  const Stopwatch watch;
  double enough = plan.follow_up ? options.enough * 2 / 3 : options.enough;
  const auto time_left = [&] {
    return options.enough > 0 ? enough - watch.seconds() : std::numeric_limits<double>::infinity();
  };
  const Execution execution{.parallel = options.parallel,
                            .limits = {options.seconds, options.mebibytes},
                            .interrupted = Interrupt::raised,
                            .enough = [&] { return time_left() < 0; }};
  std::vector<JobResult> results;
  bool complete = false;
  {
    const Interrupt interrupt;
    std::size_t to_do = 0;
    for (const std::vector<Job>& unit : left) to_do += unit.size();
    std::optional<StudyProgress> progress(std::in_place, study.name, head.jobs - to_do, head.jobs, time_left);
    const auto keep = [&](std::span<const JobResult> arrived) {
      file.add(arrived);
      for (const JobResult& result : arrived) known.emplace(result.key, result);
      progress->add(arrived);
    };
    const std::vector<std::span<const Job>> units(left.begin(), left.end());
    complete = execute(units, execution, keep);
    if (complete && head.shard.whole()) {
      enough = options.enough;
      const auto done = jobs_done(plan, known);
      results = in_plan_order(done, known);
      complete = add_follow_up(
          plan, results, execution, known,
          [&](std::size_t resumed, std::size_t jobs) { progress.emplace(study.name, resumed, jobs, time_left); }, keep);
    }
  }
  if (!complete) {
    fmt::print(stderr, "Interrupted: {} of {} results are in {}. The same command with --resume continues.\n",
               known.size(), std::max(head.jobs, known.size()), path.string());
    return interrupted_exit;
  }
  if (!head.shard.whole()) {
    fmt::print("{}\nShard {} is complete. When all shards are: plumb merge FILE ...\n",
               printable(path.string(), std::string::npos), head.shard.name());
    return 0;
  }
  const int code = write_study(study, head, plan, results, folder);
  return warn_about_limits(results, options) ? 1 : code;
}

nlohmann::ordered_json summary_document(const Study& study, const std::vector<std::string>& options, int parallel,
                                        const SummaryProgress& progress) {
  const nlohmann::ordered_json configuration = summary_configuration(study, options);
  const StudyPlan plan = study.plan(configuration);
  std::map<std::string, JobResult> known;
  execute(units_of(plan.jobs), {.parallel = parallel}, [&](std::span<const JobResult> results) {
    for (const JobResult& result : results) known.emplace(result.key, result);
    progress(results.back().key, known.size(), plan.jobs.size());
  });
  std::vector<JobResult> results = in_plan_order(plan.jobs, known);
  add_follow_up(plan, results, {.parallel = parallel});
  const ResultsHead head{.study = study.name,
                         .configuration = configuration,
                         .plan = plan_hash(plan.jobs),
                         .shard = {},
                         .jobs = results.size(),
                         .environment = environment()};
  nlohmann::ordered_json document = document_of(study, head, results, plan.conclude(results));
  document["command"] = command_of(study, options);
  return document;
}

}  // namespace plumb
