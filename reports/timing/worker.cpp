#include "reports/timing/worker.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <istream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <span>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "reports/statistics.h"
#include "reports/system/clock.h"

extern char** environ;

namespace plumb {
namespace {

using WorkerJson = nlohmann::ordered_json;

struct RunRequest {
  std::size_t runs, steps, chunk;
  double patience;  // s
};

struct RunTimes {
  std::vector<double> cpu, wall;       // s, by chunk
  std::optional<double> instructions;  // of the run
};

// For each chunk the median over the runs.
std::vector<double> medians(std::span<const RunTimes> runs, std::vector<double> RunTimes::*clock) {
  std::vector<double> all;
  for (std::size_t chunk = 0; chunk < (runs[0].*clock).size(); ++chunk) {
    std::vector<double> times;
    for (const RunTimes& run : runs) times.push_back((run.*clock)[chunk]);
    all.push_back(quartiles(std::move(times)).median);
  }
  return all;
}

class WorkerServer {
 public:
  explicit WorkerServer(const SimulationReader& read) : read_(read) {}

  const std::string& uncounted() const { return counter_.missing(); }

  WorkerJson answer(const WorkerJson& request) {
    if (!request.contains("scene")) return times_of(request);
    build_ = nullptr;
    dt_ = request.at("dt");
    build_ = read_(request.at("scene").get<std::string>(), request.at("engine").get<std::string>());
    return WorkerJson::object();
  }

 private:
  WorkerJson times_of(const WorkerJson& json) const {
    if (!build_) throw std::invalid_argument("there is no scene to step yet");
    RunRequest request{json.at("runs"), json.at("steps"), json.at("chunk"), json.at("patience")};
    if (request.runs == 0 || request.steps == 0 || request.chunk == 0)
      throw std::invalid_argument("runs, steps and chunk must be above 0");
    std::vector<RunTimes> runs{run(request)};
    request.steps = std::min(request.steps, runs[0].cpu.size() * request.chunk);
    request.patience = std::numeric_limits<double>::infinity();
    while (runs.size() < request.runs) runs.push_back(run(request));
    const std::optional<double>& instructions = runs.back().instructions;
    return {{"cpu", medians(runs, &RunTimes::cpu)},
            {"wall", medians(runs, &RunTimes::wall)},
            {"count", instructions ? WorkerJson(*instructions) : WorkerJson(nullptr)}};
  }

  RunTimes run(const RunRequest& request) const {
    const auto simulation = build_();
    RunTimes times;
    double spent = 0;
    const std::optional<double> count = counter_.count();
    for (std::size_t step = 0; step < request.steps && spent < request.patience;) {
      const std::size_t steps = std::min(request.chunk, request.steps - step);
      const Elapsed elapsed = time_steps(*simulation, dt_, steps, CpuClock::process);
      times.cpu.push_back(elapsed.cpu);
      times.wall.push_back(elapsed.wall);
      spent += elapsed.cpu;
      step += steps;
    }
    if (count) times.instructions = counter_.count().value_or(*count) - *count;
    return times;
  }

  const SimulationReader& read_;
  InstructionCounter counter_;
  FreshSimulation build_;
  double dt_ = 0;
};

// A scene of thousands of bodies, timed step by step, gives much less. A program that writes more is no worker.
constexpr std::size_t longest_answer = 16 * 1024 * 1024;

// The process reads from and writes to the socket; its standard error is discarded. Returns an error number, or 0.
int spawn_worker(const std::filesystem::path& program, const char* command, int socket, pid_t& process) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, socket, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::string name = program.string();
  std::string word = command;
  const std::array<char*, 3> arguments{name.data(), word.data(), nullptr};
  const int error = posix_spawn(&process, name.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

}  // namespace

void serve_timing(std::istream& in, std::ostream& out, const SimulationReader& read) {
  WorkerServer server(read);
  out << WorkerJson{{"pace", worker_version}, {"facts", timing_facts()}, {"uncounted", server.uncounted()}}.dump()
      << std::endl;
  for (std::string line; std::getline(in, line);) {
    WorkerJson answer;
    try {
      answer = server.answer(WorkerJson::parse(line));
    } catch (const std::exception& error) {
      answer = {{"refused", error.what()}};
    }
    out << answer.dump(-1, ' ', false, WorkerJson::error_handler_t::replace) << std::endl;
  }
}

TimingWorker::TimingWorker(std::filesystem::path program, double patience)
    : program_(std::move(program)), patience_(patience) {
  for (const char* const command : {"timing-worker", "pace"}) {  // "pace" is its name in older builds
    start(command);
    try {
      read_greeting();
      return;
    } catch (const std::runtime_error&) {
      end();
    } catch (...) {
      end();
      throw;
    }
  }
  throw std::invalid_argument(fmt::format(
      "{} is no timing worker: it is not plumb, or a build older than plumb check --time-against", program_.string()));
}

TimingWorker::~TimingWorker() { end(); }

void TimingWorker::start(const char* command) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::system_error(errno, std::generic_category(), "a socket for " + program_.string());
  const int error = spawn_worker(program_, command, ends[1], process_);
  close(ends[1]);
  socket_ = ends[0];
  received_.clear();
  if (error == 0) return;
  close(socket_);
  throw std::invalid_argument(fmt::format("{} cannot be run: {}", program_.string(), std::strerror(error)));
}

void TimingWorker::end() {
  close(socket_);
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

void TimingWorker::read_greeting() {
  const std::string line = read_line();
  WorkerJson version;
  try {
    const WorkerJson greeting = WorkerJson::parse(line);
    version = greeting.at("pace");
    facts_ = greeting.at("facts").get<TimingFacts>();
    uncounted_ = greeting.at("uncounted").get<std::string>();
  } catch (const WorkerJson::exception&) {
    fail("does not greet as a timing worker does");
  }
  if (version == worker_version) return;
  throw std::invalid_argument(fmt::format("{} uses version {} of the timing worker protocol, this program version {}",
                                          program_.string(), version.dump(), worker_version));
}

nlohmann::ordered_json TimingWorker::ask(const nlohmann::ordered_json& request) {
  const std::string text = request.dump() + "\n";
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t now = send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0) fail("ended before it had read a request");
    sent += static_cast<std::size_t>(now);
  }
  const std::string line = read_line();
  WorkerJson answer = WorkerJson::parse(line, nullptr, false);
  if (!answer.is_object()) fail(fmt::format("answers \"{:.60}\", which is no JSON object", line));
  return answer;
}

std::string TimingWorker::read_line() {
  const Stopwatch waited;
  std::array<char, 65536> piece{};
  for (std::size_t searched = 0;;) {
    const std::size_t end = received_.find('\n', searched);
    if (end != std::string::npos) {
      std::string line = received_.substr(0, end);
      received_.erase(0, end + 1);
      return line;
    }
    searched = received_.size();
    if (searched > longest_answer) fail("writes an answer without end");
    const double left = 1000 * (patience_ - waited.seconds());  // ms
    pollfd waiting{socket_, POLLIN, 0};
    const int ready = left >= 1 ? poll(&waiting, 1, static_cast<int>(left)) : 0;
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0) fail(fmt::format("took more than {:g} s to answer", patience_));
    const ssize_t now = read(socket_, piece.data(), piece.size());
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0) fail("ended without an answer");
    received_.append(piece.data(), static_cast<std::size_t>(now));
  }
}

void TimingWorker::fail(const std::string& what) const { throw std::runtime_error(program_.string() + " " + what); }

std::filesystem::path own_program() { return std::filesystem::read_symlink("/proc/self/exe"); }

}  // namespace plumb
