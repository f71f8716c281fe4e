#pragma once

#include <cmath>

#include "scenarios/scene/scene.h"

/// Vectors of the plane, so that code reads like its formulas.
namespace plumb {

inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
inline Vec operator-(Vec a) { return {-a.x, -a.y}; }
inline Vec operator*(double s, Vec a) { return {s * a.x, s * a.y}; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
inline double length(Vec a) { return std::hypot(a.x, a.y); }

/// The vector rotated by +90 degrees.
inline Vec perpendicular(Vec a) { return {-a.y, a.x}; }

/// The vector rotated counter-clockwise by an angle in rad.
inline Vec rotated(Vec a, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

}  // namespace plumb
