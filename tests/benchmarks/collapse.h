#pragma once

#include <span>
#include <string>

#include "course.h"
#include "reference/simulation.h"

namespace plumb::benchmarks {

/// How deep bodies overlap, m; zeros where none do.
struct Depth {
  double mean = 0;  // over all overlaps
  double most = 0;
};

/// How far a scene has been kept.
struct Condition {
  std::string broken;  // what became of it, that its time is no result; "" where it holds
  Depth overlap;
};

/// `states` are in the order of the scene's bodies. A scene is broken where a number is not finite, a dynamic body has
/// left the circle that it may not leave, a body no longer lies on what it was put upon, a hinge gapes by the width
/// of the smallest body, or overlaps are a quarter of it deep on the mean: one pair may be deeper, amid an impact.
Condition condition(const Start&, std::span<const BodyState> states);

}  // namespace plumb::benchmarks
