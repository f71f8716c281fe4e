#include "reports/timing/copy.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>

namespace plumb {

namespace fs = std::filesystem;

namespace {

constexpr const char* prefix = "plumb-times-";

/// Whoever lives holds a lock on its folder; a killed run has left its folder without one.
void remove_left_behind() {
  std::error_code error;
  for (fs::directory_iterator next(fs::temp_directory_path(), error), end; !error && next != end;
       next.increment(error)) {
    if (!next->path().filename().string().starts_with(prefix)) continue;
    const int folder = open(next->path().c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder < 0) continue;
    std::error_code ignored;
    if (flock(folder, LOCK_EX | LOCK_NB) == 0) fs::remove_all(next->path(), ignored);
    close(folder);
  }
}

}  // namespace

ProgramCopy::ProgramCopy(const fs::path& program) {
  remove_left_behind();
  std::string name;
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(fmt::format("{} cannot be copied to {}: {}", program.string(), name, why));
  };
  // Another process may have taken it for one left behind, until it is locked.
  while (!fs::exists(folder_)) {
    if (lock_ >= 0) close(lock_);
    name = (fs::temp_directory_path() / (std::string(prefix) + "XXXXXX")).string();
    if (mkdtemp(name.data()) == nullptr) refuse(strerror(errno));
    folder_ = name;
    lock_ = open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    flock(lock_, LOCK_EX);
  }
  path_ = folder_ / "plumb";
  std::error_code error;
  if (fs::copy_file(program, path_, error)) return;
  remove();
  refuse(error.message());
}

ProgramCopy::~ProgramCopy() { remove(); }

void ProgramCopy::remove() const {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  close(lock_);
}

}  // namespace plumb
