#include "reports/study/follow_up.h"

#include <algorithm>
#include <utility>

namespace plumb {

bool add_follow_up(const StudyPlan& plan, std::vector<JobResult>& results, const Execution& execution,
                   std::map<std::string, JobResult> known, const FollowUpStart& start,
                   const std::function<void(std::span<const JobResult>)>& keep) {
  if (!plan.follow_up) return true;
  const std::vector<Job> jobs = plan.follow_up(results);
  const auto left = units_left(units_of(jobs), known);
  start(static_cast<std::size_t>(std::ranges::count_if(jobs, [&](const Job& one) { return known.contains(one.key); })),
        jobs.size());
  const std::vector<std::span<const Job>> units(left.begin(), left.end());
  const bool complete = execute(units, execution, [&](std::span<const JobResult> arrived) {
    keep(arrived);
    for (const JobResult& one : arrived) known.emplace(one.key, one);
  });
  if (!complete) return false;
  for (const Job& job : jobs) {
    if (const auto found = known.find(job.key); found != known.end()) results.push_back(found->second);
  }
  return true;
}

std::vector<std::vector<Job>> units_left(const std::vector<std::span<const Job>>& all,
                                         const std::map<std::string, JobResult>& known) {
  std::vector<std::vector<Job>> units;
  for (const std::span<const Job> unit : all) {
    std::vector<Job> left;
    for (const Job& job : unit) {
      if (!known.contains(job.key)) left.push_back(job);
    }
    if (!left.empty()) units.push_back(std::move(left));
  }
  return units;
}

}  // namespace plumb
