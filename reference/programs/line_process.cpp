#include "reference/programs/line_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fstream>
#include <system_error>
#include <utility>

#include "scenarios/scene/json_reader.h"

extern char** environ;

namespace plumb {
namespace {

constexpr int poll_interval = 50;                          // ms, after which limits are looked at again
constexpr std::size_t longest_line = 16 * 1024 * 1024;     // bytes; 5,000 bodies take 1 MiB
constexpr std::size_t read_at_once = 256 * 1024;           // bytes
constexpr int answers_in_pipe = 1024 * 1024;               // bytes that a program may write before they are read
constexpr std::size_t kept_log = 2000;                     // bytes
constexpr std::size_t log_lines = 5;                       // of them, shown
constexpr std::chrono::milliseconds patience_at_end{200};  // until a program that was asked to end is killed

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

struct Pipe {
  int read_end = -1, write_end = -1;

  Pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("a pipe for a program");
    read_end = ends[0];
    write_end = ends[1];
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    if (read_end >= 0) close(read_end);
    if (write_end >= 0) close(write_end);
  }
};

int taken_without_waiting(int& end) {
  fcntl(end, F_SETFL, O_NONBLOCK);
  return std::exchange(end, -1);
}

// What writes to a program that has ended gets SIGPIPE. For the time of a write this thread takes it upon itself.
class NoBrokenPipe {
 public:
  NoBrokenPipe() {
    sigemptyset(&broken_pipe_);
    sigaddset(&broken_pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &broken_pipe_, &before_);
  }
  NoBrokenPipe(const NoBrokenPipe&) = delete;
  NoBrokenPipe& operator=(const NoBrokenPipe&) = delete;
  ~NoBrokenPipe() {
    const timespec now{};
    if (sigismember(&before_, SIGPIPE) == 0) sigtimedwait(&broken_pipe_, nullptr, &now);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t broken_pipe_{}, before_{};
};

std::string text_of_end(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("it was ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  }
  if (WEXITSTATUS(status) == 127) return "it could not be started: exit code 127";
  return fmt::format("it ended with exit code {} although it was not asked to", WEXITSTATUS(status));
}

// The last lines of a log, each safe to show, in one.
std::string last_lines(std::string_view log) {
  while (!log.empty() && log.back() == '\n') log.remove_suffix(1);
  std::string text;
  for (std::size_t line = 0; line < log_lines && !log.empty(); ++line) {
    const std::size_t end = log.rfind('\n');
    const std::string_view last = end == std::string_view::npos ? log : log.substr(end + 1);
    text.insert(0, printable(last, 200) + (text.empty() ? "" : " | "));
    log = end == std::string_view::npos ? std::string_view{} : log.substr(0, end);
  }
  return text;
}

}  // namespace

double resident_memory(pid_t process) {
  std::ifstream in(fmt::format("/proc/{}/statm", process));
  double all = 0;
  double resident = 0;
  in >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

std::string quoted_for_shell(const std::string& word) {
  std::string all = "'";
  for (const char c : word) all += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return all + '\'';
}

LineProcess::LineProcess(const std::string& command) {
  Pipe in;
  Pipe out;
  Pipe log;
  posix_spawn_file_actions_t files{};
  posix_spawnattr_t attributes{};
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_adddup2(&files, in.read_end, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, out.write_end, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, log.write_end, STDERR_FILENO);
  sigset_t all{};
  sigset_t none{};
  sigfillset(&all);
  sigemptyset(&none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  std::string shell = "sh";
  std::string option = "-c";
  std::string line = "exec " + command;
  std::array<char*, 4> words{shell.data(), option.data(), line.data(), nullptr};
  errno = posix_spawn(&process_, "/bin/sh", &files, &attributes, words.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (errno != 0) fail("a process for a program");
  fcntl(out.read_end, F_SETPIPE_SZ, answers_in_pipe);  // if the system allows; 64 KiB do as well, more slowly
  in_ = taken_without_waiting(in.write_end);
  out_ = taken_without_waiting(out.read_end);
  log_ = taken_without_waiting(log.read_end);
}

LineProcess::~LineProcess() {
  close(in_);
  if (process_ > 0) {
    const auto since = Clock::now();
    siginfo_t ended{};
    const auto id = static_cast<id_t>(process_);
    while (Clock::now() - since < patience_at_end && waitid(P_PID, id, &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           ended.si_pid == 0) {
      usleep(500);
    }
    kill(-process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  close(out_);
  close(log_);
}

ProgramFailure LineProcess::failure(const std::string& reason) const {
  const std::string log = last_lines(last_log_);
  return ProgramFailure(log.empty() ? reason : fmt::format("{}; its log ends: {}", reason, log));
}

void LineProcess::send(std::string_view line, const ProgramLimits& limits) {
  const std::string text = std::string(line) + '\n';
  const auto since = Clock::now();
  for (std::string_view left = text; !left.empty();) left = exchange(left, limits, since);
}

std::string_view LineProcess::receive(const ProgramLimits& limits) {
  const auto since = Clock::now();
  for (;;) {
    const std::string_view known(answers_.data(), filled_);
    const std::size_t end = known.find('\n', searched_);
    if (end != std::string_view::npos) {
      const std::string_view line = known.substr(taken_, end - taken_);
      searched_ = taken_ = end + 1;
      return line;
    }
    std::copy(known.begin() + static_cast<std::ptrdiff_t>(taken_), known.end(), answers_.begin());
    filled_ -= std::exchange(taken_, 0);
    searched_ = filled_;
    if (filled_ > longest_line) throw failure("it answered a line of more than 16 MiB");
    exchange({}, limits, since);
  }
}

std::string_view LineProcess::exchange(std::string_view text, const ProgramLimits& limits, Clock::time_point since) {
  std::array<pollfd, 3> pipes{{{out_, POLLIN, 0}, {log_, POLLIN, 0}, {text.empty() ? -1 : in_, POLLOUT, 0}}};
  poll(pipes.data(), pipes.size(), poll_interval);
  if (pipes[1].revents != 0) read_log();
  if (pipes[0].revents != 0) read_answers();
  if (pipes[2].revents != 0) {
    const NoBrokenPipe guard;
    const ssize_t sent = write(in_, text.data(), text.size());
    if (sent < 0 && errno == EPIPE) end_of_answers();
    if (sent > 0) text.remove_prefix(static_cast<std::size_t>(sent));
    return text;
  }
  const double waited = std::chrono::duration<double>(Clock::now() - since).count();
  if (waited > limits.seconds) throw failure(fmt::format("it did not answer within {} s", limits.seconds));
  if (pipes[0].revents == 0 && resident_memory(process_) > limits.mebibytes) {
    throw failure(fmt::format("it took more than {} MiB of memory", limits.mebibytes));
  }
  return text;
}

void LineProcess::read_answers() {
  if (answers_.size() < filled_ + read_at_once) answers_.resize(2 * filled_ + read_at_once);
  const ssize_t now = read(out_, answers_.data() + filled_, answers_.size() - filled_);
  if (now > 0) filled_ += static_cast<std::size_t>(now);
  if (now == 0) end_of_answers();
}

void LineProcess::read_log() {
  std::array<char, 4096> buffer{};
  const ssize_t now = read(log_, buffer.data(), buffer.size());
  if (now > 0) last_log_.append(buffer.data(), static_cast<std::size_t>(now));
  if (last_log_.size() > kept_log) last_log_.erase(0, last_log_.size() - kept_log);
  if (now == 0) close(std::exchange(log_, -1));
}

// The program has closed its output, or its input: why?
void LineProcess::end_of_answers() {
  const auto since = Clock::now();
  int status = 0;
  pid_t ended = 0;
  while ((ended = waitpid(process_, &status, WNOHANG)) == 0 && Clock::now() - since < patience_at_end) usleep(500);
  while (log_ >= 0) {
    pollfd log{log_, POLLIN, 0};
    if (poll(&log, 1, 0) <= 0) break;
    read_log();
  }
  if (ended == 0) throw failure("it closed its standard output, but did not end");
  kill(-process_, SIGKILL);  // what it may have started itself
  process_ = 0;
  throw failure(text_of_end(status));
}

}  // namespace plumb
