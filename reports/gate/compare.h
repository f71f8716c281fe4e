#pragma once

#include "reports/gate/baseline.h"
#include "reports/gate/result.h"

/// What was accepted against what is.
namespace plumb {

/// On the same platform every bit must be the same; on another, numbers may move as far as the baseline says that
/// rounding moves them. No verdict may change on either. Throws std::invalid_argument where the steps differ.
GateResult compare(const Baseline& before, const Baseline& now);
GateResult compare(const Baseline& before, const Report& now);

}  // namespace plumb
