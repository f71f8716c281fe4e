#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

/// The engines that fail in a study, which its tables then lack.
namespace plumb {

struct JobResult;

/// For each engine that failed in some of its jobs, or whose jobs crashed or exceeded their limits: in how many of how
/// many, and in which first, and why. `why` says why the engine failed in a job that is done, "" if it did not. A key
/// is "STUDY|WHAT|ENGINE|...".
nlohmann::ordered_json failures_of(const std::vector<JobResult>&,
                                   const std::function<std::string(const JobResult&)>& why);

/// The same in words, a line each; "" if none failed.
std::string failures_text(const nlohmann::ordered_json& failures);

}  // namespace plumb
