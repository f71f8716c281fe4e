#pragma once

#include <span>

#include "reports/run/run.h"

namespace plumb {

/// Prints what is rarely meant in the scene files among the cases, on standard error.
void warn_about_files(std::span<const Case>);

}  // namespace plumb
