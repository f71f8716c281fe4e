#pragma once

#include <cmath>
#include <cstdint>

#include "impulse/real.h"

namespace impulse::inline IMPULSE_PRECISION {

struct Vec2 {
  Real x = 0;
  Real y = 0;

  friend constexpr bool operator==(Vec2, Vec2) = default;
  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
  friend constexpr Vec2 operator*(Real s, Vec2 a) { return {s * a.x, s * a.y}; }
  friend constexpr Vec2 operator*(Vec2 a, Real s) { return {s * a.x, s * a.y}; }
  friend constexpr Vec2 operator/(Vec2 a, Real s) { return {a.x / s, a.y / s}; }
  constexpr Vec2& operator+=(Vec2 b) { return *this = *this + b; }
  constexpr Vec2& operator-=(Vec2 b) { return *this = *this - b; }
  constexpr Vec2& operator*=(Real s) { return *this = *this * s; }
};

constexpr Real dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }

/// The z component of the product in space: |a| |b| sin of the angle from a to b.
constexpr Real cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

/// w z x r: the velocity of a point at arm r of a body that turns at w (rad/s). v = w x r.
constexpr Vec2 cross(Real w, Vec2 r) { return {-w * r.y, w * r.x}; }

/// r x w z.
constexpr Vec2 cross(Vec2 r, Real w) { return {w * r.y, -w * r.x}; }

/// a turned by +90 degrees.
constexpr Vec2 perpendicular(Vec2 a) { return {-a.y, a.x}; }

constexpr Real length_squared(Vec2 a) { return dot(a, a); }
inline Real length(Vec2 a) { return std::sqrt(dot(a, a)); }

/// a at unit length; the zero vector stays zero.
inline Vec2 normalized(Vec2 a) {
  const Real l = length(a);
  return l > 0 ? a / l : Vec2{};
}

constexpr Vec2 min(Vec2 a, Vec2 b) { return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y}; }
constexpr Vec2 max(Vec2 a, Vec2 b) { return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y}; }
constexpr Real clamp(Real x, Real low, Real high) { return x < low ? low : (x > high ? high : x); }

/// Sine and cosine from + - * / alone, so that every compiler and library gives the same bits.
struct SinCos {
  Real sin = 0;
  Real cos = 1;
};
SinCos sin_cos(Real angle);

/// A turn by an angle, as its cosine and sine; a matrix with columns (c, s) and (-s, c).
struct Rotation {
  Real c = 1;
  Real s = 0;

  Rotation() = default;
  constexpr Rotation(Real cosine, Real sine) : c(cosine), s(sine) {}
  explicit Rotation(Real angle) {
    const SinCos of = sin_cos(angle);
    c = of.cos;
    s = of.sin;
  }
  friend constexpr bool operator==(const Rotation&, const Rotation&) = default;
  friend constexpr Vec2 operator*(Rotation q, Vec2 v) { return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y}; }
  friend constexpr Rotation operator*(Rotation q, Rotation r) { return {q.c * r.c - q.s * r.s, q.s * r.c + q.c * r.s}; }
  constexpr Rotation inverse() const { return {c, -s}; }
};

/// 2x2 matrix by its columns; m * v = v.x * x + v.y * y.
struct Mat22 {
  Vec2 x{1, 0};  // first column
  Vec2 y{0, 1};  // second column

  constexpr Mat22() = default;
  constexpr Mat22(Vec2 first_column, Vec2 second_column) : x(first_column), y(second_column) {}
  /// The rotation by an angle (rad, counter-clockwise).
  explicit Mat22(Real angle) {
    const SinCos of = sin_cos(angle);
    x = {of.cos, of.sin};
    y = {-of.sin, of.cos};
  }
  friend constexpr Vec2 operator*(const Mat22& m, Vec2 v) { return v.x * m.x + v.y * m.y; }
  friend constexpr Mat22 operator*(const Mat22& m, const Mat22& n) { return {m * n.x, m * n.y}; }
  constexpr Mat22 transposed() const { return {{x.x, y.x}, {x.y, y.y}}; }
  constexpr Real determinant() const { return cross(x, y); }
  /// The solution u of m u = b; zero where the matrix is singular.
  constexpr Vec2 solve(Vec2 b) const {
    const Real d = determinant();
    if (d == 0) return {};
    return {cross(b, y) / d, cross(x, b) / d};
  }
};

/// Where a frame is: rotation, then translation.
struct Pose {
  Vec2 p;
  Rotation q;
};

constexpr Vec2 to_world(const Pose& pose, Vec2 local) { return pose.p + pose.q * local; }
constexpr Vec2 to_local(const Pose& pose, Vec2 world) { return pose.q.inverse() * (world - pose.p); }

/// b as seen from a: the change of basis that lets two shapes collide in one shape's own frame.
constexpr Pose relative(const Pose& a, const Pose& b) { return {to_local(a, b.p), a.q.inverse() * b.q}; }

struct Aabb {
  Vec2 low;
  Vec2 high;
};

constexpr bool overlap(const Aabb& a, const Aabb& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}
constexpr bool contains(const Aabb& box, Vec2 p) {
  return box.low.x <= p.x && p.x <= box.high.x && box.low.y <= p.y && p.y <= box.high.y;
}
constexpr Aabb merged(const Aabb& a, const Aabb& b) { return {min(a.low, b.low), max(a.high, b.high)}; }
constexpr Aabb grown(const Aabb& a, Real by) { return {a.low - Vec2{by, by}, a.high + Vec2{by, by}}; }

}  // namespace impulse::inline IMPULSE_PRECISION
