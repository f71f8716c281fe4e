#pragma once

#include <functional>
#include <span>
#include <vector>

#include "reports/study/job.h"
#include "reports/study/job_process.h"

namespace plumb {

struct Execution {
  int parallel = 1;  // jobs that run at the same time; timed jobs and those that want to be alone have the machine
  JobLimits limits = {};
  std::function<bool()> interrupted = [] { return false; };
};

/// Jobs that must stay together: a group, or a single job. In order.
std::vector<std::span<const Job>> units_of(std::span<const Job>);

/// Runs all jobs of the units. `keep` receives results as soon as they are final: one at a time, or a whole group.
/// Returns false if it was interrupted; the results of jobs under way are then lost.
bool execute(std::span<const std::span<const Job>> units, const Execution&,
             const std::function<void(std::span<const JobResult>)>& keep);

}  // namespace plumb
