#pragma once

#include <cmath>

#include "reference/simulation.h"
#include "scenarios/scene/scene.h"

/// Vectors of the plane, as the formulas are written.
namespace plumb {

inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
inline Vec operator-(Vec a) { return {-a.x, -a.y}; }
inline Vec operator*(double s, Vec a) { return {s * a.x, s * a.y}; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
inline double length(Vec a) { return std::hypot(a.x, a.y); }
inline Vec left_of(Vec a) { return {-a.y, a.x}; }
inline Vec turned(Vec a, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

/// Where a force and nothing else takes a body: r + v t + a t^2/2, angle + w t (Galileo).
inline BodyState thrown(const BodyState& start, Vec acceleration, double t) {
  return {.position = start.position + t * start.velocity + (t * t / 2) * acceleration,
          .angle = start.angle + t * start.angular_velocity,
          .velocity = start.velocity + t * acceleration,
          .angular_velocity = start.angular_velocity};
}

}  // namespace plumb
