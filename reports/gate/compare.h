#pragma once

#include "reports/gate/baseline.h"
#include "reports/gate/result.h"

namespace plumb {

/// Compares results with what was accepted. On the same platform every bit must be the same; on another one, numbers
/// may differ by their bounds. Verdicts must be the same on both. Throws std::invalid_argument if the time steps
/// differ.
GateResult compare(const Baseline& before, const Baseline& now);
GateResult compare(const Baseline& before, const Report& now);

}  // namespace plumb
