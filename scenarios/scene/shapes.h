#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "scenarios/scene/maps.h"
#include "scenarios/scene/scene.h"

/// All operations that depend on the kind of shape: mass properties, outlines, maps, reading from and writing to scene
/// files.
namespace plumb {

class JsonReader;

/// As in scene files: "circle".
const char* kind_name(const Geometry&);

/// The mass properties of a shape of density 1. All zero for segments and half-spaces.
struct Area {
  double area = 0;           // m^2
  Vec center;                // m, the centroid, in the body frame
  double second_moment = 0;  // m^4, about the centroid
};

/// Sources: disc pi r^2 and A r^2/2; rectangle w h and A (w^2 + h^2)/12; polygon by Green's theorem; capsule as a
/// rectangle and two half discs.
Area area_of(const Geometry&);

/// The outline of a shape: the convex hull of its points grown by a radius (a disc is one point, a capsule two), or all
/// that lies below a line.
struct Outline {
  std::vector<Vec> points;             // in order around, in either direction
  double radius = 0;                   // m
  std::optional<HalfSpace> halfspace;  // if set, there are no points
};

/// In the body's frame, moved so that `origin` of that frame becomes (0, 0).
Outline outline_of(const Geometry&, Vec origin);

/// The outline rotated by an angle, rad, and then moved by a position.
Outline placed(const Outline&, Vec position, double angle);

/// The shape with all its points mapped.
Geometry mapped(const Geometry&, const FrameMap&);

/// One of a body's shapes, with its surface. Throws std::invalid_argument if it is not a valid shape.
Shape read_shape(const JsonReader&);
nlohmann::ordered_json as_json(const Shape&);

}  // namespace plumb
