#include "reports/timing/pacer.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "reports/timing/pace.h"

extern char** environ;

namespace plumb {
namespace {

// Not even a scene of thousands of bodies, step by step, comes near it: a program that talks on is no pacer.
constexpr std::size_t longest_answer = 16 * 1024 * 1024;

// Both its input and its output are the one socket; what it has to say besides goes nowhere.
int spawn(const std::filesystem::path& program, const std::string& without, int socket, pid_t& process) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, socket, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::string name = program.string();
  std::string word = "pace";
  const std::array<char*, 3> arguments{name.data(), word.data(), nullptr};
  std::vector<char*> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    if (without.empty() || std::string_view(*variable).rfind(without + "=", 0) != 0) variables.push_back(*variable);
  }
  variables.push_back(nullptr);
  const int error = posix_spawn(&process, name.c_str(), &actions, nullptr, arguments.data(), variables.data());
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

}  // namespace

Pacer::Pacer(std::filesystem::path program, const Options& options)
    : program_(std::move(program)), patience_(options.patience) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::system_error(errno, std::generic_category(), "a socket for " + program_.string());
  const int error = spawn(program_, options.without, ends[1], process_);
  close(ends[1]);
  to_and_from_ = ends[0];
  if (error != 0) {
    close(to_and_from_);
    throw std::invalid_argument(fmt::format("{} cannot be run: {}", program_.string(), std::strerror(error)));
  }
  try {
    greet();
  } catch (...) {
    end();
    throw;
  }
}

Pacer::~Pacer() { end(); }

void Pacer::end() {
  close(to_and_from_);
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

void Pacer::greet() {
  Json version;
  try {
    const Json said = Json::parse(line());
    version = said.at("pace");
    facts_ = said.at("facts");
    uncounted_ = said.at("uncounted");
  } catch (const std::exception&) {
    throw std::invalid_argument(
        fmt::format("{} does not know how to step on request: it is no plumb, or older than plumb check --time-against",
                    program_.string()));
  }
  if (version == pace_version) return;
  throw std::invalid_argument(fmt::format("{} steps on request by version {} of the protocol, this program by {}",
                                          program_.string(), version.dump(), pace_version));
}

Pacer::Json Pacer::ask(const Json& request) {
  const std::string text = request.dump() + "\n";
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t now = send(to_and_from_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0) fail("ended while it was asked");
    sent += static_cast<std::size_t>(now);
  }
  const std::string said = line();
  Json answer = Json::parse(said, nullptr, false);
  if (!answer.is_object()) fail(fmt::format("answers \"{:.60}\", which is no JSON object", said));
  return answer;
}

std::string Pacer::line() {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::duration<double>(patience_);
  std::array<char, 65536> piece{};
  for (std::size_t searched = 0;;) {
    const std::size_t end = heard_.find('\n', searched);
    if (end != std::string::npos) {
      std::string line = heard_.substr(0, end);
      heard_.erase(0, end + 1);
      return line;
    }
    searched = heard_.size();
    if (searched > longest_answer) fail("answers without end");
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    pollfd waited{to_and_from_, POLLIN, 0};
    const int ready = left > 0 ? poll(&waited, 1, static_cast<int>(left)) : 0;
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0) fail(fmt::format("took more than {:g} s to answer", patience_));
    const ssize_t now = read(to_and_from_, piece.data(), piece.size());
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0) fail("ended without an answer");
    heard_.append(piece.data(), static_cast<std::size_t>(now));
  }
}

void Pacer::fail(const std::string& what) const { throw std::runtime_error(program_.string() + " " + what); }

std::filesystem::path own_program() { return std::filesystem::read_symlink("/proc/self/exe"); }

}  // namespace plumb
