#include "reports/system/processes.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <sstream>

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr int not_started = 127;  // the exit code that shells use
constexpr int signalled = 128;

// Where the streams of a process go.
class Streams {
 public:
  Streams() { posix_spawn_file_actions_init(&actions_); }
  ~Streams() { posix_spawn_file_actions_destroy(&actions_); }
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;

  void discard(int stream) { posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null", O_RDWR, 0); }
  void redirect(int stream, int to) { posix_spawn_file_actions_adddup2(&actions_, to, stream); }

  // Starts a process; nullopt if that fails.
  std::optional<pid_t> spawn(std::vector<std::string> words, short flags) const {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, flags);
    pid_t process = 0;
    const int error = posix_spawnp(&process, pointers.front(), &actions_, &attributes, pointers.data(), environ);
    posix_spawnattr_destroy(&attributes);
    return error == 0 ? std::optional(process) : std::nullopt;
  }

 private:
  posix_spawn_file_actions_t actions_;
};

int exit_code_of(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) return not_started;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : signalled + WTERMSIG(status);
}

std::string read_to_end(int descriptor) {
  std::string text;
  char piece[512];
  for (ssize_t count = 0; (count = read(descriptor, piece, sizeof piece)) != 0;) {
    if (count > 0) text.append(piece, static_cast<std::size_t>(count));
    if (count < 0 && errno != EINTR) break;
  }
  return text;
}

}  // namespace

std::optional<fs::path> find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder) / name;
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0) return file;
  }
  return std::nullopt;
}

int run_program(const std::vector<std::string>& words) {
  const auto process = Streams().spawn(words, 0);
  return process ? exit_code_of(*process) : not_started;
}

std::optional<std::string> output_of(const std::vector<std::string>& words) {
  int pipe_ends[2];
  if (pipe2(pipe_ends, O_CLOEXEC) != 0) return std::nullopt;
  Streams streams;
  streams.redirect(STDOUT_FILENO, pipe_ends[1]);
  streams.discard(STDERR_FILENO);
  const auto process = streams.spawn(words, 0);
  close(pipe_ends[1]);
  std::string text = read_to_end(pipe_ends[0]);
  close(pipe_ends[0]);
  if (!process || exit_code_of(*process) != 0) return std::nullopt;
  if (text.ends_with('\n')) text.pop_back();
  return text;
}

bool start_program(const std::vector<std::string>& words) {
  Streams streams;
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) streams.discard(stream);
  return streams.spawn(words, POSIX_SPAWN_SETSID).has_value();
}

}  // namespace plumb
