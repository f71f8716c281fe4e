#include "reports/study/child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <system_error>

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr int moment = 10;  // ms between looks at time and memory: few against what a point takes
constexpr int up = 3;       // where a child's pipe to its parent is

// Few for what is slow; up to 15 while the middle half of them spreads over more than a tenth of the median.
constexpr RepetitionRule turn_rule{
    .fewest = 5, .most = 15, .budget = 1.5, .wide = 0.1, .slow = 0.1, .fewest_if_slow = 3};

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

// All of it, or the parent is gone.
void say(const std::string& line) {
  for (std::size_t sent = 0; sent < line.size();) {
    const ssize_t now = write(up, line.data() + sent, line.size() - sent);
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0) _exit(1);
    sent += static_cast<std::size_t>(now);
  }
}

// A child has two pipes and nothing else of its parent's: not its terminal, not the file of results. It leaves
// interruptions to the parent, and dies with it.
void settle(pid_t parent, int in, int out) {
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(in, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  dup2(out, up);
  close_range(up + 1, ~0U, 0);
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
}

void answer(const Point& point) {
  PointResult result{.key = point.key};
  try {
    result.row = point.run();
  } catch (const std::bad_alloc&) {
    result.ending = Ending::out_of_memory;
  } catch (const std::exception& error) {
    result.ending = Ending::failed;
    result.reason = error.what();
  }
  say(to_line(result));
  char ask = 0;
  while (result.ending == Ending::done && point.turn && read(STDIN_FILENO, &ask, 1) == 1) {
    say(fmt::format("{}\n", point.turn()));
  }
}

[[noreturn]] void live(const Point& point) {
  try {
    answer(point);
  } catch (...) {
    std::abort();  // a turn threw although the run did not
  }
  _exit(0);
}

// MiB in use; 0 where the system does not tell.
double memory_of(pid_t process) {
  std::ifstream in(fmt::format("/proc/{}/statm", process));
  double all = 0;
  double resident = 0;
  in >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

std::string told(int status) {
  if (WIFSIGNALED(status)) return fmt::format("ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return fmt::format("ended without an answer, with exit code {}", WEXITSTATUS(status));
}

}  // namespace

Child::Child(const Point& point) : point_(point), result_{.key = point.key}, repetitions_(turn_rule) {
  std::array<int, 2> answers{};
  std::array<int, 2> asks{};
  if (pipe2(answers.data(), O_CLOEXEC) != 0) fail("a pipe for a point");
  if (pipe2(asks.data(), O_CLOEXEC) != 0) {
    close(answers[0]);
    close(answers[1]);
    fail("a pipe for a point");
  }
  std::fflush(nullptr);  // or what stands in buffers could be written twice
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) {
    settle(parent, asks[0], answers[1]);
    live(point);
  }
  from_ = answers[0];
  to_ = asks[1];
  close(answers[1]);
  close(asks[0]);
  if (process_ < 0) {
    close(from_);
    close(to_);
    fail("a process for a point");
  }
  fcntl(from_, F_SETFL, O_NONBLOCK);
}

Child::~Child() {
  if (process_ > 0) bury();
}

void Child::take_turn() {
  busy_ = true;
  since_ = Clock::now();
  // One that is gone is noticed when it is listened to.
  const auto ignored = std::signal(SIGPIPE, SIG_IGN);
  [[maybe_unused]] const ssize_t sent = write(to_, "t", 1);
  std::signal(SIGPIPE, ignored);
}

void Child::attend(std::span<const std::unique_ptr<Child>> children, const Limits& limits) {
  std::vector<pollfd> pipes;
  std::vector<Child*> busy;
  for (const std::unique_ptr<Child>& child : children) {
    if (!child->busy()) continue;
    pipes.push_back({child->from_, POLLIN, 0});
    busy.push_back(child.get());
  }
  poll(pipes.data(), pipes.size(), moment);
  for (std::size_t i = 0; i < busy.size(); ++i) {
    if (pipes[i].revents != 0) busy[i]->listen();
    if (busy[i]->busy()) busy[i]->check(limits);
  }
}

void Child::listen() {
  std::array<char, 4096> piece{};
  while (busy_) {
    const ssize_t now = read(from_, piece.data(), piece.size());
    if (now < 0 && errno == EINTR) continue;
    if (now < 0) return;  // that is all for now
    if (now == 0) {
      // The process is past the point where its exit code could still change.
      kill(process_, SIGKILL);
      int status = 0;
      waitpid(process_, &status, 0);
      process_ = 0;
      end(Ending::crashed, told(status));
      return;
    }
    said_.append(piece.data(), static_cast<std::size_t>(now));
    if (said_.back() == '\n') hear(said_);  // it says one line at a time, and waits
  }
}

void Child::hear(const std::string& line) {
  busy_ = false;
  if (line.front() == '{') {
    result_ = from_line(line);
    if (!point_.turn || result_.ending != Ending::done) bury();
  } else {
    const double seconds = std::stod(line);
    if (std::isfinite(seconds)) {
      repetitions_.add(seconds, waited());
    } else {
      bury();
    }
  }
  said_.clear();
}

double Child::waited() const { return std::chrono::duration<double>(Clock::now() - since_).count(); }

void Child::check(const Limits& limits) {
  if (waited() > limits.seconds) {
    end(Ending::timed_out, fmt::format("took more than {} s", limits.seconds));
  } else if (memory_of(process_) > limits.mebibytes) {
    end(Ending::out_of_memory, fmt::format("took more than {} MiB", limits.mebibytes));
  }
}

void Child::end(Ending ending, const std::string& reason) {
  busy_ = false;
  result_.ending = ending;
  result_.reason = reason;
  if (process_ > 0 || from_ >= 0) bury();
}

void Child::bury() {
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

}  // namespace plumb
