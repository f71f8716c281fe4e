#pragma once

#include <cmath>

/// Vectors of the plane, in double, so that code reads like its formulas.
namespace plumb {

struct Vec {
  double x = 0;
  double y = 0;
  friend bool operator==(const Vec&, const Vec&) = default;
};

inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
inline Vec operator-(Vec v) { return {-v.x, -v.y}; }
inline Vec operator*(double s, Vec v) { return {s * v.x, s * v.y}; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
inline double length(Vec v) { return std::sqrt(dot(v, v)); }

/// The vector rotated by +90 degrees.
inline Vec perpendicular(Vec v) { return {-v.y, v.x}; }

/// The vector rotated as (1, 0) is to `facing`, of unit length.
inline Vec rotated(Vec v, Vec facing) { return {facing.x * v.x - facing.y * v.y, facing.y * v.x + facing.x * v.y}; }

/// The vector rotated counter-clockwise by an angle, rad.
inline Vec rotated(Vec v, double angle) { return rotated(v, Vec{std::cos(angle), std::sin(angle)}); }

}  // namespace plumb
