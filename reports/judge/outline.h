#pragma once

#include <optional>
#include <span>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// A shape's outline: the convex hull of its points grown by a radius (a disc is one point, a capsule two), or all that
/// lies below a line.
struct Outline {
  std::vector<Vec> points;             // in order around, either way
  double radius = 0;                   // m
  std::optional<HalfSpace> halfspace;  // then there are no points
};

/// In the body's frame, moved so that `origin` of that frame becomes (0, 0).
Outline outline_of(const Geometry&, Vec origin);

/// The outline at a place, turned by an angle.
Outline placed(const Outline&, Vec position, double angle);

/// The smallest and the largest value of direction . p over the outline; `direction` is of unit length. Without bound
/// for a half-space, where nothing is returned.
struct Interval {
  double low = 0, high = 0;
};
std::optional<Interval> range_along(Vec direction, const Outline&);

/// The gap between two outlines in m: their distance, or less the depth by which one must be moved out of the other.
/// Two half-spaces have none: infinity.
double gap_between(const Outline&, const Outline&);

}  // namespace plumb
