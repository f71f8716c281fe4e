#pragma once

#include <sys/types.h>

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "reports/study/job.h"
#include "reports/system/clock.h"
#include "reports/timing/repetitions.h"

/// Running jobs, each in a child process.
namespace plumb {

/// A job that takes more is ended.
struct JobLimits {
  double seconds = 60;      // for its run, and again for each repetition
  double mebibytes = 4096;  // resident memory
  /// Of processors, by the process and by those that it has waited for, in all.
  double processor_seconds = std::numeric_limits<double>::infinity();
};

/// A child process that runs one job. Only a process without other threads may fork one.
class JobProcess {
 public:
  /// Starts the job at once. The job must outlive this object. Throws std::system_error if there is no process or pipe
  /// for it.
  JobProcess(const Job&, const JobLimits&);
  JobProcess(const JobProcess&) = delete;
  JobProcess& operator=(const JobProcess&) = delete;
  ~JobProcess();

  /// The run or a repetition is under way.
  bool busy() const { return busy_; }
  /// The run is done and a repetition can start.
  bool ready() const { return process_ > 0 && !busy_; }
  /// Starts a repetition. The process must be ready.
  void start_repetition();

  const Job& job() const { return job_; }
  const JobResult& result() const { return result_; }
  /// All repetitions so far.
  const Repetitions& repetitions() const { return repetitions_; }

  /// Waits up to a few milliseconds for output of the busy processes, reads it, and ends processes beyond their limits.
  static void attend(std::span<const std::unique_ptr<JobProcess>>, const JobLimits&);

 private:
  void read_output();
  void take_line(const std::string& line);
  void check(const JobLimits&);
  void finish(Ending, const std::string& reason);
  void kill_process();

  const Job& job_;
  JobResult result_;
  pid_t process_ = 0;
  int from_ = -1, to_ = -1;  // pipes
  bool busy_ = true;
  Stopwatch since_;
  std::string partial_line_;
  Repetitions repetitions_;
};

struct Execution {
  int parallel = 1;  // jobs that run at the same time; timed jobs and those that want to be alone have the machine
  JobLimits limits = {};
  std::function<bool()> interrupted = [] { return false; };
  std::function<bool()> enough = [] { return false; };  // no further job starts; those under way end
};

/// Runs all jobs of the units, or the first of them if it was enough. `keep` receives results as soon as they are
/// final: one at a time, or a whole group. Returns false if it was interrupted; the results of jobs under way are then
/// lost.
bool execute(std::span<const std::span<const Job>> units, const Execution&,
             const std::function<void(std::span<const JobResult>)>& keep);

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
