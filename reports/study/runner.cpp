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
#include <system_error>

#include "reports/statistics.h"

namespace plumb {
namespace {

constexpr int poll_interval = 10;  // ms between checks of time and memory; short compared with a job
constexpr int parent_pipe = 3;     // file descriptor of a child's pipe to its parent

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

void run_job(const Job& job) {
  JobResult result{.key = job.key};
  try {
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

[[noreturn]] void run_child(const Job& job) {
  try {
    run_job(job);
  } catch (...) {
    std::abort();  // a repetition threw although the run did not
  }
  _exit(0);
}

// MiB of resident memory; 0 if the system does not tell.
double memory_of(pid_t process) {
  std::ifstream in(fmt::format("/proc/{}/statm", process));
  double all = 0;
  double resident = 0;
  in >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

std::string exit_text(int status) {
  if (WIFSIGNALED(status)) return fmt::format("ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return fmt::format("ended without a result, with exit code {}", WEXITSTATUS(status));
}

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

JobProcess::JobProcess(const Job& job) : job_(job), result_{.key = job.key} {
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
    run_child(job);
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
  since_ = Clock::now();
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
      repetitions_.push_back(seconds);
      time_spent_ += time_waited();
      if (repetitions_.size() == 1) first_time_spent_ = time_spent_;
    } else {
      kill_process();
    }
  }
  partial_line_.clear();
}

double JobProcess::time_waited() const { return std::chrono::duration<double>(Clock::now() - since_).count(); }

void JobProcess::check(const JobLimits& limits) {
  if (time_waited() > limits.seconds) {
    finish(Ending::timed_out, fmt::format("took more than {} s", limits.seconds));
  } else if (memory_of(process_) > limits.mebibytes) {
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
