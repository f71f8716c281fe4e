#include "reports/system/tool.h"

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

constexpr int not_started = 127;  // as shells have it
constexpr int signalled = 128;

class Actions {
 public:
  Actions() { posix_spawn_file_actions_init(&actions_); }
  ~Actions() { posix_spawn_file_actions_destroy(&actions_); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;

  void silence() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
      posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null", O_RDWR, 0);
    }
  }

  // The process, or nothing.
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

}  // namespace

std::optional<fs::path> find_tool(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path place = fs::path(folder) / name;
    std::error_code ignored;
    if (fs::is_regular_file(place, ignored) && access(place.c_str(), X_OK) == 0) return place;
  }
  return std::nullopt;
}

int run_tool(const std::vector<std::string>& words) {
  const auto process = Actions().spawn(words, 0);
  if (!process) return not_started;
  int status = 0;
  while (waitpid(*process, &status, 0) < 0) {
    if (errno != EINTR) return not_started;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : signalled + WTERMSIG(status);
}

bool start_tool(const std::vector<std::string>& words) {
  Actions actions;
  actions.silence();
  return actions.spawn(words, POSIX_SPAWN_SETSID).has_value();
}

}  // namespace plumb
