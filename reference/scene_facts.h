#pragma once

#include <string>

#include "scenarios/scene/scene.h"

/// What adapters ask of a scene before they build it.
namespace plumb {

/// Metres from the origin within which everything stays while nothing but gravity and the speeds of the start carry it;
/// at least 100. Engines without half-spaces get an edge that long to either side.
double reach(const Scene&);

/// m, the diameter of the disc with the radius of gyration of the smallest dynamic body; 1 where none has an extent.
double smallest_body(const Scene&);

/// Why an engine with a single coefficient of friction cannot run it; "" when it can.
std::string needs_two_frictions(const Scene&);

/// Why an engine that makes half-spaces from edges of fixed bodies cannot run it; "" when it can.
std::string needs_dynamic_half_space(const Scene&);

/// Why an engine that gives every dynamic body mass cannot run it; "" when it can.
std::string needs_massless_body(const Scene&);

/// The body's frame moved to its centre of mass: position and shapes change, the motion does not. Engines and closed
/// forms differ in whether "velocity" is that of the frame's origin; in this frame there is no difference.
Body centered(const Body&);

}  // namespace plumb
