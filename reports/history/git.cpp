#include "reports/history/git.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <utility>
#include <vector>

#include "reports/history/moment.h"

namespace plumb {
namespace {

// What a program wrote before it ended well, without its last line break.
std::optional<std::string> said_by(std::vector<std::string> words) {
  int pipe_ends[2];
  if (pipe2(pipe_ends, O_CLOEXEC) != 0) return std::nullopt;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, pipe_ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = 0;
  const int why_not = posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(pipe_ends[1]);
  std::string said;
  char piece[512];
  for (ssize_t many = 0; (many = read(pipe_ends[0], piece, sizeof piece)) != 0;) {
    if (many > 0) said.append(piece, static_cast<std::size_t>(many));
    if (many < 0 && errno != EINTR) break;
  }
  close(pipe_ends[0]);
  if (why_not != 0) return std::nullopt;
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  if (status != 0) return std::nullopt;
  if (!said.empty() && said.back() == '\n') said.pop_back();
  return said;
}

}  // namespace

std::optional<Commit> find_commit(const std::string& revision) {
  if (revision.rfind('-', 0) == 0) return std::nullopt;  // git would take it for an option
  const std::string asked = (revision.empty() ? "HEAD" : revision) + "^{commit}";
  // A hash names each commit, tags or not.
  auto hash = revision.empty() ? said_by({"git", "describe", "--always", "--abbrev=40", "--exclude=*", "--dirty"})
                               : said_by({"git", "rev-parse", "--verify", asked});
  const auto at = said_by({"git", "show", "--no-patch", "--format=%cI", asked});
  if (!hash || !at) return std::nullopt;
  return Commit{std::move(*hash), utc(*at)};
}

}  // namespace plumb
