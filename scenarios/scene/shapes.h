#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scenarios/scene/scene.h"

/// All operations that depend on the kind of shape: mass properties, scaling, reading from and writing to scene files.
namespace plumb {

class JsonReader;

/// The mass properties of a shape of density 1. All zero for segments and half-spaces.
struct Area {
  double area = 0;           // m^2
  Vec center;                // m, the centroid, in the body frame
  double second_moment = 0;  // m^4, about the centroid
};

/// Sources: disc pi r^2 and A r^2/2; rectangle w h and A (w^2 + h^2)/12; polygon by Green's theorem; capsule as a
/// rectangle and two half discs.
Area area_of(const Geometry&);

/// The shape with every length multiplied by `factor`.
Geometry scaled(const Geometry&, double factor);
inline Vec scaled(Vec v, double factor) { return {factor * v.x, factor * v.y}; }

/// One of a body's shapes, with its surface. Throws std::invalid_argument if it is not a valid shape.
Shape read_shape(const JsonReader&);
nlohmann::ordered_json as_json(const Shape&);

}  // namespace plumb
