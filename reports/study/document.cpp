#include "reports/study/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <stdexcept>

#include "reports/study/runner.h"
#include "reports/system/files.h"
#include "reports/system/jobs.h"
#include "reports/writers/html.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/json_reader.h"
#include "scenarios/scene/nearest.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr int document_format = 2;  // increased when a reader of the previous format would misread the document

void add_new(std::vector<std::string>& names, const Json& object) {
  for (const auto& [name, value] : object.items()) {
    if (value.is_structured() || std::find(names.begin(), names.end(), name) != names.end()) continue;
    names.push_back(name);
  }
}

std::string fields(const std::vector<std::string>& names, const Json& object) {
  std::string text;
  for (const std::string& name : names) {
    text += ',';
    const auto found = object.find(name);
    if (found == object.end() || found->is_null()) continue;
    text += found->is_number()   ? found->dump()
            : found->is_string() ? csv_field(found->get<std::string>())
                                 : csv_field(found->dump());
  }
  return text;
}

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

Json document_of(const Study& study, const ResultsHead& head, const std::vector<JobResult>& results,
                 const Findings& found) {
  Json all = Json::array();
  Json times = Json::object();
  for (const JobResult& result : results) {
    all.push_back({{"key", result.key},
                   {"ending", name_of(result.ending)},
                   {"reason", result.reason},
                   {"values", result.output.values}});
    if (!result.output.times.empty()) times[result.key] = result.output.times;
  }
  Json timings = found.timings;
  timings["results"] = std::move(times);
  return {{"plumb", document_format},
          {"study", study.name},
          {"about", study.about},
          {"configuration", head.configuration},
          {"environment", head.environment},
          {"results", std::move(all)},
          {"findings", found.findings},
          {"timings", std::move(timings)}};
}

std::string csv_of(const std::vector<JobResult>& results) {
  std::vector<std::string> values;
  std::vector<std::string> times;
  for (const JobResult& result : results) {
    add_new(values, result.output.values);
    add_new(times, result.output.times);
  }
  std::string text = "key,ending,reason";
  for (const std::string& name : values) text += "," + csv_field(name);
  for (const std::string& name : times) text += "," + csv_field("time_" + name);
  text += "\n";
  for (const JobResult& result : results) {
    text += csv_field(result.key) + "," + name_of(result.ending) + "," + csv_field(result.reason) +
            fields(values, result.output.values) + fields(times, result.output.times) + "\n";
  }
  return text;
}

int write_study(const Study& study, const ResultsHead& head, const StudyPlan& plan,
                const std::vector<JobResult>& results, const OutputFolder& folder) {
  const Findings found = plan.conclude(results);
  const Json document = document_of(study, head, results, found);
  const std::string stem = "study-" + study.name;
  std::vector<std::pair<std::string, std::string>> files{{stem + ".json", document.dump(1) + "\n"},
                                                         {stem + ".csv", csv_of(results)}};
  std::string why_not;
  Json shown = document;
  shown["folder"] = folder.path().string();
  if (auto page = fill_page(page_template(), Json{{"study", std::move(shown)}}, why_not)) {
    files.emplace_back(stem + ".html", std::move(*page));
  }
  const std::size_t own = files.size();
  files.insert(files.end(), found.files.begin(), found.files.end());
  const auto paths = folder.put(files);
  fmt::print("{}", found.text);
  for (const auto& path : std::span(paths).first(std::min(own, paths.size())))
    fmt::print("{}\n", printable(path.string(), std::string::npos));
  if (paths.size() > own) {
    const std::size_t more = paths.size() - own - 1;
    fmt::print("{}{}\n", printable(paths[own].string(), std::string::npos),
               more > 0 ? fmt::format(" and {} more", more) : "");
  }
  if (!why_not.empty()) fmt::print("No {}.html: {}.\n", stem, why_not);
  return found.failed ? 1 : 0;
}

int merge_shards(const std::vector<fs::path>& paths, const OutputFolder& folder) {
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
  std::vector<JobResult> results = in_plan_order(plan.jobs, by_key);
  add_follow_up(plan, results, {.parallel = default_jobs()});
  head.shard = {};
  head.jobs = results.size();
  return write_study(study, head, plan, results, folder);
}

}  // namespace plumb
