#include "reports/study/failures.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "reports/study/job.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

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
