#include "reports/cli/file_warnings.h"

#include <fmt/core.h>

#include "reports/run/scene_file.h"
#include "reports/run/scene_warnings.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {

void warn_about_files(std::span<const Case> cases) {
  for (const Case& one : cases) {
    if (one.from_file == nullptr || one.variant == tracker) continue;
    std::vector<std::string> warnings = warnings_about(*one.scene);
    warnings.insert(warnings.end(), one.left_out.begin(), one.left_out.end());
    for (const std::string& warning : warnings)
      fmt::print(stderr, "plumb: warning: {}: {}\n", printable(one.variant, one.variant.npos), warning);
  }
}

}  // namespace plumb
