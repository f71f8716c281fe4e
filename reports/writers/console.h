#pragma once

#include <string>

#include "reports/report.h"

namespace plumb {

/// The report as tables of at most 100 columns.
std::string console_text(const Report&, bool colour);

}  // namespace plumb
