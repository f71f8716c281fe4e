#include "reports/gate/timing_copy.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>

namespace plumb {

namespace fs = std::filesystem;

ProgramCopy::ProgramCopy(const fs::path& program) {
  std::string name = (fs::temp_directory_path() / "plumb-times-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::invalid_argument(fmt::format("{} cannot be copied to {}: {}", program.string(), name, strerror(errno)));
  folder_ = name;
  path_ = folder_ / "plumb";
  std::error_code error;
  if (fs::copy_file(program, path_, error)) return;
  fs::remove_all(folder_);
  throw std::invalid_argument(fmt::format("{} cannot be copied to {}: {}", program.string(), name, error.message()));
}

ProgramCopy::~ProgramCopy() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

}  // namespace plumb
