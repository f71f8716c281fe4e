#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "reports/study/job.h"
#include "reports/study/runner.h"

namespace plumb {

/// Told of the jobs that will run and of how many results there are already, before they start.
using FollowUpStart = std::function<void(std::size_t known, std::size_t jobs)>;

/// Runs the jobs that follow from a plan's results (`StudyPlan::follow_up`), apart from those that have a result in
/// `known`, and appends all their results to `results`, in order. `keep` receives them as they arrive. Returns false if
/// it was interrupted; `results` is then as it was.
bool add_follow_up(
    const StudyPlan&, std::vector<JobResult>& results, const Execution&, std::map<std::string, JobResult> known = {},
    const FollowUpStart& start = [](std::size_t, std::size_t) {},
    const std::function<void(std::span<const JobResult>)>& keep = [](std::span<const JobResult>) {});

/// The units without the jobs that already have a result.
std::vector<std::vector<Job>> units_left(const std::vector<std::span<const Job>>& all,
                                         const std::map<std::string, JobResult>& known);

}  // namespace plumb
