#include "reports/study/shard.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <stdexcept>

#include "reports/study/document.h"
#include "reports/study/runner.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/nearest.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

struct ShardFile {
  fs::path path;
  StoredResults stored;
};

const Study& study_of(const ShardFile& file) {
  const std::string& name = file.stored.head.study;
  if (const Study* study = Catalog<Study>::find(name)) return *study;
  std::vector<std::string> names;
  for (const Study* study : Catalog<Study>::all()) names.push_back(study->name);
  throw std::invalid_argument(file.path.string() + ": " + unknown("study", name, names));
}

// Collects messages, to throw them all at once.
class Problems {
 public:
  template <class... Arguments>
  void add(fmt::format_string<Arguments...> what, Arguments&&... arguments) {
    text_ += (text_.empty() ? "" : "\n") + fmt::format(what, std::forward<Arguments>(arguments)...);
  }
  void raise() const {
    if (!text_.empty()) throw std::invalid_argument(text_);
  }

 private:
  std::string text_;
};

void check_heads(const std::vector<ShardFile>& files, Problems& problems) {
  const ShardFile& first = files.front();
  const int n = first.stored.head.shard.n;
  std::map<int, fs::path> found;
  for (const auto& [path, stored] : files) {
    const Shard& shard = stored.head.shard;
    const std::string difference = stored.head.difference_from(first.stored.head);
    if (!difference.empty()) {
      problems.add("{} does not belong to {}: it has {}", path.string(), first.path.string(), difference);
    } else if (shard.n != n) {
      problems.add("{} is shard {} and {} is shard {}: they overlap", path.string(), shard.name(), first.path.string(),
                   first.stored.head.shard.name());
    } else if (const auto [other, added] = found.emplace(shard.k, path); !added) {
      problems.add("{} and {} are both shard {}", other->second.string(), path.string(), shard.name());
    }
  }
  problems.raise();
  for (int k = 1; k <= n; ++k) {
    if (!found.contains(k)) problems.add("shard {} is missing", Shard{k, n}.name());
  }
}

void check_results(const ShardFile& file, const std::vector<std::span<const Job>>& units, Problems& problems) {
  std::set<std::string> own;
  for (const auto& unit : units) {
    for (const Job& job : unit) own.insert(job.key);
  }
  for (const auto& [key, result] : file.stored.results) {
    if (!own.contains(key)) {
      problems.add("{}: \"{}\" is not in shard {}", file.path.string(), key, file.stored.head.shard.name());
    }
  }
  std::size_t missing = 0;
  std::string first;
  for (const std::string& key : own) {
    if (!file.stored.results.contains(key) && missing++ == 0) first = key;
  }
  if (missing > 0) {
    problems.add("{}: {} of {} results are missing, the first is \"{}\"; run its command again with --resume",
                 file.path.string(), missing, own.size(), first);
  }
}

// Shards may have run on different machines: the environment of the whole lists all of them.
void add_machine(const ResultsHead& from, ResultsHead& to) {
  for (const char* key : {"system", "processor", "processors"}) {
    std::string& all = to.environment[key];
    const auto other = from.environment.find(key);
    if (other == from.environment.end() || (", " + all + ",").find(", " + other->second + ",") != std::string::npos)
      continue;
    all += (all.empty() ? "" : ", ") + other->second;
  }
}

}  // namespace

// An array's task numbers start where the user wants, at 0 as often as at 1, and may have a step: --array=0-6:2.
std::optional<Shard> slurm_shard(const EnvironmentLookup& lookup) {
  if (lookup("SLURM_ARRAY_TASK_ID") == nullptr) return std::nullopt;
  const auto read = [&](const char* name, std::optional<int> otherwise) {
    const char* text = lookup(name);
    const auto number = text == nullptr ? otherwise : parse_integer(text);
    if (!number) {
      throw std::invalid_argument(
          fmt::format("{}: \"{}\" is not an integer; give --shard k/n", name, text ? text : ""));
    }
    return *number;
  };
  const int id = read("SLURM_ARRAY_TASK_ID", std::nullopt);
  const int count = read("SLURM_ARRAY_TASK_COUNT", std::nullopt);
  const int first = read("SLURM_ARRAY_TASK_MIN", std::nullopt);
  const int step = read("SLURM_ARRAY_TASK_STEP", 1);
  const int last = read("SLURM_ARRAY_TASK_MAX", first + (count - 1) * step);
  const bool even = step > 0 && last == first + (count - 1) * step && (id - first) % step == 0;
  if (!even || id < first || id > last) {
    throw std::invalid_argument(
        fmt::format("the Slurm array has {} tasks from {} to {} with gaps; give --shard k/n", count, first, last));
  }
  return Shard{(id - first) / step + 1, count};
}

std::vector<std::span<const Job>> units_in(const Shard& shard, const std::vector<std::span<const Job>>& units) {
  std::vector<std::span<const Job>> own;
  const auto n = static_cast<std::size_t>(shard.n);
  for (std::size_t i = static_cast<std::size_t>(shard.k) - 1; i < units.size(); i += n) own.push_back(units[i]);
  return own;
}

void merge_shards(const std::vector<fs::path>& paths, const OutputFolder& folder) {
  std::vector<ShardFile> files;
  for (const fs::path& path : paths) files.push_back({path, read_results(path)});
  if (files.empty()) throw std::invalid_argument("there are no files to merge");

  const Study& study = study_of(files.front());
  ResultsHead head = files.front().stored.head;
  Problems problems;
  check_heads(files, problems);
  const StudyPlan plan = study.plan(head.configuration);
  if (plan_hash(plan.jobs) != head.plan) {
    throw std::invalid_argument(files.front().path.string() +
                                ": this plumb plans other jobs for that configuration: another version made the file");
  }
  const auto units = units_of(plan.jobs);
  for (const ShardFile& file : files) check_results(file, units_in(file.stored.head.shard, units), problems);
  problems.raise();

  std::map<std::string, JobResult> by_key;
  for (ShardFile& file : files) {
    add_machine(file.stored.head, head);
    by_key.merge(file.stored.results);
  }
  const std::vector<JobResult> results = in_plan_order(plan.jobs, by_key);
  head.shard = {};
  head.jobs = results.size();
  write_study(study, head, plan, results, folder);
}

}  // namespace plumb
