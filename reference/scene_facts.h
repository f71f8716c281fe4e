#pragma once

#include <variant>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scene/scene.h"

/// Facts that adapters, closed forms and reports read off a scene.
namespace plumb {

/// State of the centre of mass at the start.
BodyState start_of(const Body&);
/// The same for all bodies, in Scene order.
std::vector<BodyState> start_of(const Scene&);

/// Gravitational acceleration of the body, m/s^2: scaled as the body says, zero unless it is dynamic.
Vec gravity_of(const Scene&, const Body&);

/// The body with its frame's origin at its centre of mass: position and shapes change, the motion does not. Engines and
/// closed forms differ in whether "velocity" is that of the origin; in this frame the two agree.
Body centered(const Body&);

/// m, from the centre of mass to the farthest point of the body; half-spaces do not count.
double bounding_radius(const Body&);

/// Diameter in m of the disc with the smallest radius of gyration among the dynamic bodies; 1 if none has an extent.
double smallest_body(const Scene&);

/// The only shape of a body if it is of that kind, else null.
template <class Kind>
const Kind* only_shape(const Body& body) {
  return body.shapes.size() == 1 ? std::get_if<Kind>(&body.shapes.front().geometry) : nullptr;
}

}  // namespace plumb
