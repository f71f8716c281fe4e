#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "scenarios/scene/scene.h"

namespace plumb {

/// What there is to draw: {"outlines", "bodies", "ties"}. An outline is {"points": [[x, y] ...], "radius"}, the convex
/// hull of its points grown by a radius, or {"normal", "offset"}, all that lies below a line. A body is {"name",
/// "type", "outlines": indices}, its frame moved to the centre of mass. A tie joins two points, of a joint or a spring:
/// {"a", "b", "at_a", "at_b"}, in the bodies' frames; `a` is null for a point of the world.
nlohmann::ordered_json outlines_of(const Scene&);

/// By body, m: the farthest any of its points lies from the centre of mass; 0 where it has no bounds, or no shape.
std::vector<double> radii_of(const Scene&);

}  // namespace plumb
