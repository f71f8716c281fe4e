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
inline double length(Vec v) { return std::hypot(v.x, v.y); }

/// The vector rotated by +90 degrees.
inline Vec perpendicular(Vec v) { return {-v.y, v.x}; }

/// The vector rotated counter-clockwise by an angle, rad.
inline Vec rotated(Vec v, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

}  // namespace plumb
