#pragma once

#include <functional>
#include <span>
#include <vector>

#include "reports/study/child.h"
#include "reports/study/point.h"

namespace plumb {

struct Execution {
  int jobs = 1;  // points run at once; those that are timed or alone have the machine for themselves
  Limits limits = {};
  std::function<bool()> interrupted = [] { return false; };
};

/// Points that must stay together: one, or a group. In order.
std::vector<std::span<const Point>> units_of(std::span<const Point>);

/// Finds out all of them. `keep` is told what is finished, as soon as it is: a point, or a whole group. Returns false
/// when it was interrupted; then what was under way is lost.
bool execute(std::span<const std::span<const Point>> units, const Execution&,
             const std::function<void(std::span<const PointResult>)>& keep);

}  // namespace plumb
