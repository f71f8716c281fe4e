#include "reports/study/runner.h"

#include <algorithm>
#include <iterator>
#include <memory>

#include "reports/statistics.h"

namespace plumb {
namespace {

using Processes = std::vector<std::unique_ptr<JobProcess>>;

// Repetitions of a timed job. The first is a warm-up and does not count, unless it took so long that warming up did not
// matter. If the middle half of the times spreads over more than `wide` of the median, more repetitions follow; if that
// does not help, the job is marked.
constexpr std::size_t fewest = 5;
constexpr std::size_t fewest_of_slow = 3;
constexpr std::size_t most_repetitions = 15;
constexpr double slow = 0.1;    // s of repetitions of one job, after which a few are enough
constexpr double costly = 1.5;  // s, after which a wide spread is accepted
constexpr double wide = 0.1;

struct Interrupted {};

std::span<const double> counted(const JobProcess& process) {
  const std::span<const double> times = process.repetitions();
  return times.subspan(times.empty() || process.first_time_spent() > slow ? 0 : 1);
}

Quartiles spread(std::span<const double> times) { return quartiles({times.begin(), times.end()}); }

bool is_wide(const Quartiles& of) { return of.high - of.low > wide * of.median; }

bool wants_repetition(const JobProcess& process) {
  if (!process.ready()) return false;
  const std::span<const double> times = counted(process);
  if (times.size() < fewest_of_slow) return true;
  if (times.size() < fewest && process.time_spent() < slow) return true;
  return times.size() < most_repetitions && process.time_spent() < costly && is_wide(spread(times));
}

JobResult result_of(const JobProcess& process) {
  JobResult result = process.result();
  const std::span<const double> times = counted(process);
  if (times.empty()) return result;
  const Quartiles of = spread(times);
  result.output.times["median"] = of.median;
  result.output.times["low"] = of.low;
  result.output.times["high"] = of.high;
  result.output.times["repetitions"] = times.size();
  result.output.times["wide"] = is_wide(of);
  return result;
}

class Runner {
 public:
  explicit Runner(const Execution& execution) : execution_(execution) {}

  // Runs the jobs, up to `parallel` at a time. `finished` receives each process whose run has ended; only repetitions
  // may be left.
  void run(std::span<const Job* const> jobs, int parallel,
           const std::function<void(std::unique_ptr<JobProcess>)>& finished) const {
    Processes working;
    for (std::size_t next = 0; next < jobs.size() || !working.empty();) {
      while (next < jobs.size() && working.size() < static_cast<std::size_t>(std::max(parallel, 1))) {
        if (jobs[next]->prepare) jobs[next]->prepare();
        working.push_back(std::make_unique<JobProcess>(*jobs[next++]));
      }
      attend(working);
      const auto idle =
          std::stable_partition(working.begin(), working.end(), [](const auto& one) { return one->busy(); });
      std::for_each(idle, working.end(), [&](auto& one) { finished(std::move(one)); });
      working.erase(idle, working.end());
    }
  }

  // Alternates the repetitions of the processes; each round starts with a different one.
  void repeat(Processes& processes) const {
    for (std::size_t round = 0;; ++round) {
      bool any = false;
      for (std::size_t i = 0; i < processes.size(); ++i) {
        const std::span<const std::unique_ptr<JobProcess>> one(&processes[(round + i) % processes.size()], 1);
        if (!wants_repetition(*one[0])) continue;
        any = true;
        one[0]->start_repetition();
        while (one[0]->busy()) attend(one);
      }
      if (!any) return;
    }
  }

 private:
  void attend(std::span<const std::unique_ptr<JobProcess>> processes) const {
    JobProcess::attend(processes, execution_.limits);
    if (execution_.interrupted()) throw Interrupted{};
  }

  const Execution& execution_;
};

bool is_timed(std::span<const Job> unit) {
  return std::any_of(unit.begin(), unit.end(), [](const Job& job) { return job.repetition != nullptr; });
}

bool needs_machine(std::span<const Job> unit) {
  return is_timed(unit) || std::any_of(unit.begin(), unit.end(), [](const Job& job) { return job.alone; });
}

}  // namespace

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

bool execute(std::span<const std::span<const Job>> units, const Execution& execution,
             const std::function<void(std::span<const JobResult>)>& keep) {
  const Runner runner(execution);
  const auto keep_one = [&](const std::unique_ptr<JobProcess>& process) {
    const JobResult result = result_of(*process);
    keep({&result, 1});
  };
  try {
    for (std::size_t i = 0; i < units.size();) {
      std::vector<const Job*> jobs;
      if (!needs_machine(units[i])) {
        for (; i < units.size() && !needs_machine(units[i]); ++i) {
          for (const Job& job : units[i]) jobs.push_back(&job);
        }
        runner.run(jobs, execution.parallel, keep_one);
        continue;
      }
      for (const Job& job : units[i]) jobs.push_back(&job);
      const bool timed = is_timed(units[i++]);
      Processes processes;
      runner.run(jobs, timed ? execution.parallel : 1,
                 [&](std::unique_ptr<JobProcess> process) { processes.push_back(std::move(process)); });
      // In the plan's order, not in the order in which the runs ended: the order of repetitions never depends on
      // chance.
      std::sort(processes.begin(), processes.end(), [](const auto& a, const auto& b) { return &a->job() < &b->job(); });
      runner.repeat(processes);
      std::vector<JobResult> results;
      std::transform(processes.begin(), processes.end(), std::back_inserter(results),
                     [](const auto& process) { return result_of(*process); });
      keep(results);
    }
  } catch (const Interrupted&) {
    return false;
  }
  return true;
}

}  // namespace plumb
