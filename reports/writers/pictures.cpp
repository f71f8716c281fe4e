#include "reports/writers/pictures.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>

#include "reports/system/files.h"
#include "reports/system/processes.h"
#include "reports/writers/page.h"

namespace plumb {

void check_pictures() {
  if (picture_program().empty())
    throw std::invalid_argument("--svg: Plumb was built without Node.js, so there is no page to take pictures of");
  if (!find_program("node")) throw std::invalid_argument("--svg needs Node.js 18 or newer: apt-get install nodejs");
}

void take_pictures(const std::filesystem::path& page, const std::filesystem::path& folder) {
  check_pictures();
  NewFile program(std::filesystem::temp_directory_path() / fmt::format("plumb-pictures-{}.cjs", getpid()));
  if (!program.write(std::string(picture_program()))) throw std::runtime_error("cannot write a temporary file");
  const auto file = program.put_in_place();
  std::fflush(stdout);
  const int code = run_program({"node", file.string(), page.string(), folder.string()});
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  if (code != 0) throw std::runtime_error(fmt::format("the pictures were not taken: node ended with {}", code));
}

}  // namespace plumb
