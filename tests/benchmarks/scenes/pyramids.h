#pragma once

#include "../benchmark_scene.h"

namespace plumb::benchmarks {

/// Adds boxes of 1 m in rows, side by side without gaps, each box on two of the row below. `middle` is the middle of
/// the lowest row's lower edge.
void add_pyramid(SceneSetup&, int base, Vec middle);

}  // namespace plumb::benchmarks
