#pragma once

#include <cstddef>
#include <string>

#include "reports/report.h"

namespace plumb {

struct ConsoleOptions {
  bool colour = false;
  bool verbose = false;     // also every two engines of each case, and all checks that failed
  std::size_t width = 100;  // columns
};

/// The report as a table a scenario, and each engine in one line.
std::string console_text(const Report&, const ConsoleOptions& = {});

}  // namespace plumb
