#pragma once

#include "../course.h"

namespace plumb::benchmarks {

/// Adds boxes of 1 m in rows, each row side by side without a gap, each box on two of the row below. `middle` is the
/// middle of the lowest row's lower edge.
void add_pyramid(Start&, int base, Vec middle);

}  // namespace plumb::benchmarks
