#pragma once

#include <cmath>

#include "scenarios/scene/scene.h"

/// Vector algebra in double, shared by everything that evaluates runs.
namespace plumb {

inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
inline Vec operator*(double s, Vec v) { return {s * v.x, s * v.y}; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
inline double length(Vec v) { return std::hypot(v.x, v.y); }

/// v rotated counter-clockwise by an angle, rad.
inline Vec rotated(Vec v, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

}  // namespace plumb
