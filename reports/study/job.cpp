#include "reports/study/job.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "reports/run/catalog_case.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::pair<Ending, const char*> endings[] = {{Ending::done, "done"},
                                                      {Ending::failed, "failed"},
                                                      {Ending::crashed, "crashed"},
                                                      {Ending::timed_out, "timed out"},
                                                      {Ending::out_of_memory, "out of memory"}};

Ending ending_of(const std::string& name) {
  for (const auto& [ending, word] : endings) {
    if (name == word) return ending;
  }
  throw std::invalid_argument("unknown ending of a job: \"" + name + "\"");
}

}  // namespace

const char* name_of(Ending wanted) {
  for (const auto& [ending, word] : endings) {
    if (ending == wanted) return word;
  }
  return "";
}

std::string key_part(const std::string& key, int index) {
  std::size_t begin = 0;
  for (; index > 0; --index) {
    const std::size_t bar = key.find('|', begin);
    if (bar == std::string::npos) return "";
    begin = bar + 1;
  }
  return key.substr(begin, key.find('|', begin) - begin);
}

std::string to_line(const JobResult& result) {
  // An engine's error message may not be valid UTF-8: `replace` keeps dump from throwing.
  return Json{{"key", result.key},
              {"ending", name_of(result.ending)},
              {"reason", result.reason},
              {"values", result.output.values},
              {"times", result.output.times}}
             .dump(-1, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

JobResult from_line(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    return {.key = json.at("key"),
            .ending = ending_of(json.at("ending")),
            .reason = json.at("reason"),
            .output = {json.at("values"), json.at("times")}};
  } catch (const Json::exception& error) {
    throw std::invalid_argument(error.what());
  }
}

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::vector<std::span<const Job>> units_of(std::span<const Job> jobs) {
  std::vector<std::span<const Job>> units;
  for (std::size_t i = 0; i < jobs.size();) {
    std::size_t end = i + 1;
    while (!jobs[i].group.empty() && end < jobs.size() && jobs[end].group == jobs[i].group) ++end;
    units.push_back(jobs.subspan(i, end - i));
    i = end;
  }
  return units;
}

std::string Shard::name() const { return fmt::format("{}/{}", k, n); }

Shard parse_shard(std::string_view text) {
  constexpr int most_shards = 100000;
  const auto slash = text.find('/');
  if (slash != std::string_view::npos) {
    const auto k = parse_integer(text.substr(0, slash));
    const auto n = parse_integer(text.substr(slash + 1));
    if (k && n && *k >= 1 && *k <= *n && *n <= most_shards) return {*k, *n};
  }
  throw std::invalid_argument(fmt::format("--shard: \"{}\" is not k/n with 1 <= k <= n, such as 1/4", text));
}

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

Json failures_of(const std::vector<JobResult>& results, const std::function<std::string(const JobResult&)>& why) {
  Json all = Json::array();
  for (const JobResult& result : results) {
    const std::string engine = key_part(result.key, 2);
    auto found = std::find_if(all.begin(), all.end(), [&](const Json& one) { return one.at("engine") == engine; });
    if (found == all.end()) {
      all.push_back({{"engine", engine}, {"failed", 0}, {"jobs", 0}, {"first", ""}, {"why", ""}});
      found = all.end() - 1;
    }
    Json& one = *found;
    one["jobs"] = one["jobs"].get<int>() + 1;
    const std::string reason =
        result.ending == Ending::done ? why(result) : fmt::format("{}: {}", name_of(result.ending), result.reason);
    if (reason.empty()) continue;
    if (one["failed"] == 0) one.update({{"first", key_part(result.key, 1)}, {"why", reason}});
    one["failed"] = one["failed"].get<int>() + 1;
  }
  Json failures = Json::array();
  std::copy_if(all.begin(), all.end(), std::back_inserter(failures),
               [](const Json& one) { return one.at("failed") != 0; });
  return failures;
}

std::string failures_text(const Json& failures) {
  std::string text;
  for (const Json& one : failures) {
    text += fmt::format("{} failed in {} of {} jobs, first in {}: {}\n", one.at("engine").get<std::string>(),
                        one.at("failed").get<int>(), one.at("jobs").get<int>(), one.at("first").get<std::string>(),
                        printable(one.at("why").get<std::string>(), 300));
  }
  return text;
}

}  // namespace plumb
