#include "reports/study/conduct.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "reports/study/document.h"
#include "reports/study/results_file.h"
#include "reports/study/runner.h"
#include "reports/study/shard.h"
#include "reports/system/environment.h"
#include "reports/system/terminal.h"
#include "reports/writers/output.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr int interrupted = 130;  // as a shell has it for Ctrl-C

Shard shard_of(const StudyOptions& options) {
  if (!options.shard.empty()) return parse_shard(options.shard);
  return slurm_shard([](const char* name) { return std::getenv(name); }).value_or(Shard{});
}

std::string file_of(const Study& study, const Shard& shard) {
  return shard.whole() ? fmt::format("study-{}.jsonl", study.name)
                       : fmt::format("study-{}-{}-of-{}.jsonl", study.name, shard.k, shard.n);
}

// What an earlier run left, where there is something to go on with.
std::optional<KeptResults> kept_in(const fs::path& path, const ResultsHead& head, const StudyOptions& options) {
  if (options.fresh || !fs::exists(path)) return std::nullopt;
  if (!options.resume) {
    const KeptResults kept = read_results(path);
    if (kept.results.size() >= kept.head.points) return std::nullopt;
    throw std::invalid_argument(
        fmt::format("{} holds {} of {} points of a study that was interrupted: --resume goes on "
                    "with it, --fresh begins anew",
                    path.string(), kept.results.size(), kept.head.points));
  }
  KeptResults kept = read_results(path);
  std::string foreign = kept.head.foreign_to(head);
  if (foreign.empty() && kept.head.shard != head.shard) {
    foreign = fmt::format("shard {}, not {}", kept.head.shard.name(), head.shard.name());
  }
  if (!foreign.empty()) {
    throw std::invalid_argument(fmt::format("{} is of {}: give another --out, or --fresh", path.string(), foreign));
  }
  return kept;
}

std::string duration_of(double seconds) {
  const auto s = static_cast<long>(std::lround(seconds));
  if (s < 100) return fmt::format("{} s", s);
  return s < 6000 ? fmt::format("{} min {} s", s / 60, s % 60) : fmt::format("{} h {} min", s / 3600, s / 60 % 60);
}

class ProgressTable {
 public:
  ProgressTable(std::size_t known, std::size_t all) : known_(known), done_(known), all_(all) { show(""); }

  void add(std::span<const PointResult> results) {
    done_ += results.size();
    show(results.back().key);
  }
  std::size_t done() const { return done_; }

 private:
  using Clock = std::chrono::steady_clock;

  void show(const std::string& last) const {
    const double spent = std::chrono::duration<double>(Clock::now() - begun_).count();
    const double each = spent / static_cast<double>(std::max<std::size_t>(done_ - known_, 1));
    const std::string left =
        done_ == known_ ? "" : duration_of(each * static_cast<double>(all_ - done_)) + " left; last ";
    line_.show(fmt::format("[{}/{}] {}{}", done_, all_, left, last));
  }

  std::size_t known_, done_, all_;
  Clock::time_point begun_ = Clock::now();
  ProgressLine line_;
};

// The units of a shard without the points that are known.
std::vector<std::vector<Point>> unknown_of(const std::vector<std::span<const Point>>& share,
                                           const std::map<std::string, PointResult>& known) {
  std::vector<std::vector<Point>> units;
  for (const std::span<const Point> unit : share) {
    std::vector<Point> left;
    for (const Point& point : unit) {
      if (!known.contains(point.key)) left.push_back(point);
    }
    if (!left.empty()) units.push_back(std::move(left));
  }
  return units;
}

}  // namespace

void StudyOptions::attach_to(CLI::App& app) {
  app.add_option("--out", out, "Folder for the results, study-NAME.json, .csv and .html")
      ->capture_default_str()
      ->type_name("DIR");
  app.add_option("--jobs", jobs, "Points run at once; what is timed has the machine for itself")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  app.add_flag("--resume", resume, "Go on with what an interrupted run left in the folder, if it left something");
  app.add_flag("--fresh", fresh, "Begin anew, whatever is there");
  app.add_option("--shard", shard, "Only the k-th of n parts, for `plumb merge`; a Slurm array's task by default")
      ->type_name("k/n");
  app.add_option("--time-limit", seconds, "s that a point may take")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 1e7))
      ->type_name("S");
  app.add_option("--memory-limit", mebibytes, "MiB that a point may take")
      ->capture_default_str()
      ->check(CLI::Range(16.0, 1e9))
      ->type_name("MIB");
}

int conduct(const Study& study, const nlohmann::ordered_json& configuration, const StudyOptions& options) {
  if (options.resume && options.fresh) throw std::invalid_argument("--resume and --fresh contradict each other");
  const StudyPlan plan = study.plan(configuration);
  ResultsHead head{.study = study.name,
                   .configuration = configuration,
                   .plan = plan_hash(plan.points),
                   .shard = shard_of(options),
                   .environment = environment()};
  const auto share = share_of(head.shard, units_of(plan.points));
  for (const std::span<const Point> unit : share) head.points += unit.size();
  const OutputFolder folder(options.out);
  const fs::path path = folder.path() / file_of(study, head.shard);
  const std::optional<KeptResults> kept = kept_in(path, head, options);
  std::map<std::string, PointResult> known;
  if (kept) known = kept->results;

  ResultsFile file = kept ? ResultsFile::go_on(path, *kept) : ResultsFile::begin(path, head);
  const std::vector<std::vector<Point>> left = unknown_of(share, known);
  Execution how{.jobs = options.jobs, .limits = {options.seconds, options.mebibytes}, .interrupted = Interrupt::raised};
  bool complete = false;
  {
    const Interrupt interrupt;
    ProgressTable progress(known.size(), head.points);
    const std::vector<std::span<const Point>> units(left.begin(), left.end());
    complete = execute(units, how, [&](std::span<const PointResult> results) {
      file.add(results);
      for (const PointResult& result : results) known.emplace(result.key, result);
      progress.add(results);
    });
  }
  if (!complete) {
    fmt::print(stderr, "Interrupted: {} of {} points are kept in {}. The same command with --resume goes on.\n",
               known.size(), head.points, path.string());
    return interrupted;
  }
  if (!head.shard.whole()) {
    fmt::print("{}\nShard {} is complete. When all are: plumb merge FILE ...\n", path.string(), head.shard.name());
    return 0;
  }
  std::vector<PointResult> results;
  for (const Point& point : plan.points) results.push_back(known.at(point.key));
  write_study(study, head, plan, results, folder);
  return 0;
}

}  // namespace plumb
