#include "reports/study/runner.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <new>
#include <sstream>
#include <string>
#include <system_error>

#include "reference/programs/line_process.h"
#include "reports/timing/repetitions.h"

namespace plumb {
namespace {

constexpr int poll_interval = 10;  // ms between checks of time and memory; short compared with a job
constexpr int parent_pipe = 3;     // file descriptor of a child's pipe to its parent

// Few repetitions of what is slow; up to 15 while the middle half of the times spreads over more than a tenth of the
// median.
constexpr RepetitionRule repetition_rule{
    .fewest = 5, .most = 15, .budget = 1.5, .wide = 0.1, .slow = 0.1, .fewest_if_slow = 3};

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

// In the child: writes the whole line, or exits because the parent is gone.
void send_to_parent(const std::string& line) {
  for (std::size_t sent = 0; sent < line.size();) {
    const ssize_t now = write(parent_pipe, line.data() + sent, line.size() - sent);
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0) _exit(1);
    sent += static_cast<std::size_t>(now);
  }
}

// A child keeps two pipes and nothing else of its parent: neither the terminal nor the results file. It leaves
// interruptions to the parent and dies with it.
void isolate_child(pid_t parent, int in, int out) {
  const int null_device = open("/dev/null", O_WRONLY);
  dup2(in, STDIN_FILENO);
  dup2(null_device, STDOUT_FILENO);
  dup2(null_device, STDERR_FILENO);
  dup2(out, parent_pipe);
  close_range(parent_pipe + 1, ~0U, 0);
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
}

void run_job(const Job& job, double seconds) {
  JobResult result{.key = job.key};
  try {
    if (job.within) job.within(seconds);
    result.output = job.run();
  } catch (const std::bad_alloc&) {
    result.ending = Ending::out_of_memory;
  } catch (const std::exception& error) {
    result.ending = Ending::failed;
    result.reason = error.what();
  }
  send_to_parent(to_line(result));
  char request = 0;
  while (result.ending == Ending::done && job.repetition && read(STDIN_FILENO, &request, 1) == 1) {
    send_to_parent(fmt::format("{}\n", job.repetition()));
  }
}

[[noreturn]] void run_child(const Job& job, double seconds) {
  try {
    run_job(job, seconds);
  } catch (...) {
    std::abort();  // a repetition threw although the run did not
  }
  _exit(0);
}

std::string exit_text(int status) {
  if (WIFSIGNALED(status)) return fmt::format("ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return fmt::format("ended without a result, with exit code {}", WEXITSTATUS(status));
}

// s; 0 for a process that is gone.
double processor_time(pid_t process) {
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  const std::string text(std::istreambuf_iterator<char>(file), {});
  // The second field is a name in parentheses, which may contain anything; user and system time are the 14th and 15th,
  // those of children that ended the next two.
  std::istringstream fields(text.substr(std::min(text.rfind(')') + 1, text.size())));
  std::string skipped;
  for (int field = 3; field < 14; ++field) fields >> skipped;
  double user = 0;
  double system = 0;
  double children_user = 0;
  double children_system = 0;
  fields >> user >> system >> children_user >> children_system;
  return (user + system + children_user + children_system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

using Processes = std::vector<std::unique_ptr<JobProcess>>;

struct Interrupted {};

JobResult result_of(const JobProcess& process) {
  JobResult result = process.result();
  const std::size_t repetitions = process.repetitions().counted().size();
  if (repetitions == 0) return result;
  const Quartiles spread = process.repetitions().spread();
  result.output.times["median"] = spread.median;
  result.output.times["low"] = spread.low;
  result.output.times["high"] = spread.high;
  result.output.times["repetitions"] = repetitions;
  result.output.times["wide"] = process.repetitions().wide();
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
      if (execution_.enough()) next = jobs.size();
      while (next < jobs.size() && working.size() < static_cast<std::size_t>(std::max(parallel, 1))) {
        if (jobs[next]->prepare) jobs[next]->prepare();
        working.push_back(std::make_unique<JobProcess>(*jobs[next++], execution_.limits));
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
    repeat_until_settled(processes.size(), [&](std::size_t i) {
      const std::span<const std::unique_ptr<JobProcess>> one(&processes[i], 1);
      if (!one[0]->ready() || one[0]->repetitions().settled()) return false;
      one[0]->start_repetition();
      while (one[0]->busy()) attend(one);
      return true;
    });
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

JobProcess::JobProcess(const Job& job, const JobLimits& limits)
    : job_(job), result_{.key = job.key}, repetitions_(repetition_rule) {
  std::array<int, 2> results{};
  std::array<int, 2> requests{};
  if (pipe2(results.data(), O_CLOEXEC) != 0) fail("a pipe for a job");
  if (pipe2(requests.data(), O_CLOEXEC) != 0) {
    close(results[0]);
    close(results[1]);
    fail("a pipe for a job");
  }
  std::fflush(nullptr);  // otherwise the child could write buffered output a second time
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) {
    isolate_child(parent, requests[0], results[1]);
    run_child(job, limits.seconds);
  }
  from_ = results[0];
  to_ = requests[1];
  close(results[1]);
  close(requests[0]);
  if (process_ < 0) {
    close(from_);
    close(to_);
    fail("a process for a job");
  }
  fcntl(from_, F_SETFL, O_NONBLOCK);
}

JobProcess::~JobProcess() {
  if (process_ > 0) kill_process();
}

void JobProcess::start_repetition() {
  busy_ = true;
  since_ = Stopwatch();
  // If the process is gone, the next read notices.
  const auto previous = std::signal(SIGPIPE, SIG_IGN);
  [[maybe_unused]] const ssize_t sent = write(to_, "t", 1);
  std::signal(SIGPIPE, previous);
}

void JobProcess::attend(std::span<const std::unique_ptr<JobProcess>> processes, const JobLimits& limits) {
  std::vector<pollfd> pipes;
  std::vector<JobProcess*> busy;
  for (const std::unique_ptr<JobProcess>& process : processes) {
    if (!process->busy()) continue;
    pipes.push_back({process->from_, POLLIN, 0});
    busy.push_back(process.get());
  }
  poll(pipes.data(), pipes.size(), poll_interval);
  for (std::size_t i = 0; i < busy.size(); ++i) {
    if (pipes[i].revents != 0) busy[i]->read_output();
    if (busy[i]->busy()) busy[i]->check(limits);
  }
}

void JobProcess::read_output() {
  std::array<char, 4096> buffer{};
  while (busy_) {
    const ssize_t now = read(from_, buffer.data(), buffer.size());
    if (now < 0 && errno == EINTR) continue;
    if (now < 0) return;  // nothing more for now
    if (now == 0) {
      // The process has closed its pipe: its exit status can no longer change, so the kill is safe.
      kill(process_, SIGKILL);
      int status = 0;
      waitpid(process_, &status, 0);
      process_ = 0;
      finish(Ending::crashed, exit_text(status));
      return;
    }
    partial_line_.append(buffer.data(), static_cast<std::size_t>(now));
    if (partial_line_.back() == '\n') take_line(partial_line_);  // the child writes one line at a time, then waits
  }
}

void JobProcess::take_line(const std::string& line) {
  busy_ = false;
  if (line.front() == '{') {
    result_ = from_line(line);
    if (!job_.repetition || result_.ending != Ending::done) kill_process();
  } else {
    const double seconds = std::stod(line);
    if (std::isfinite(seconds)) {
      repetitions_.add(seconds, since_.seconds());
    } else {
      kill_process();
    }
  }
  partial_line_.clear();
}

void JobProcess::check(const JobLimits& limits) {
  if (since_.seconds() > limits.seconds) {
    finish(Ending::timed_out, fmt::format("took more than {} s", limits.seconds));
  } else if (std::isfinite(limits.processor_seconds) && processor_time(process_) > limits.processor_seconds) {
    finish(Ending::timed_out, fmt::format("took more than {} s of a processor", limits.processor_seconds));
  } else if (resident_memory(process_) > limits.mebibytes) {
    finish(Ending::out_of_memory, fmt::format("took more than {} MiB", limits.mebibytes));
  }
}

void JobProcess::finish(Ending ending, const std::string& reason) {
  busy_ = false;
  result_.ending = ending;
  result_.reason = reason;
  if (process_ > 0 || from_ >= 0) kill_process();
}

void JobProcess::kill_process() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  process_ = 0;
  busy_ = false;
  if (from_ >= 0) close(from_);
  if (to_ >= 0) close(to_);
  from_ = to_ = -1;
}

bool execute(std::span<const std::span<const Job>> units, const Execution& execution,
             const std::function<void(std::span<const JobResult>)>& keep) {
  const Runner runner(execution);
  const auto keep_one = [&](const std::unique_ptr<JobProcess>& process) {
    const JobResult result = result_of(*process);
    keep({&result, 1});
  };
  try {
    for (std::size_t i = 0; i < units.size() && !execution.enough();) {
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
