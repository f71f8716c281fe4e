#pragma once

#include <cmath>
#include <cstdint>

/// Precision is chosen here and nowhere else. The same source is compiled once for float and once for double; an
/// inline namespace keeps the two apart, so one program can link both. Users write impulse::World and link
/// impulse::impulse (float) or impulse::impulse_double (which defines IMPULSE_DOUBLE).
#ifdef IMPULSE_DOUBLE
#define IMPULSE_PRECISION double_precision
#else
#define IMPULSE_PRECISION single_precision
#endif

namespace impulse::inline IMPULSE_PRECISION {

#ifdef IMPULSE_DOUBLE
using Real = double;
#else
using Real = float;
#endif

constexpr Real pi = static_cast<Real>(3.14159265358979323846);

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

inline bool is_finite(Real x) { return std::isfinite(x); }
inline bool is_finite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }

constexpr Real dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }

/// The z component of the 3D cross product: |a| |b| times the sine of the angle from a to b.
constexpr Real cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

/// v = w x r: the velocity of a point at arm r on a body with angular velocity w (rad/s).
constexpr Vec2 cross(Real w, Vec2 r) { return {-w * r.y, w * r.x}; }

/// r x w, the opposite of w x r.
constexpr Vec2 cross(Vec2 r, Real w) { return {w * r.y, -w * r.x}; }

/// a rotated by +90 degrees.
constexpr Vec2 perpendicular(Vec2 a) { return {-a.y, a.x}; }

constexpr Real length_squared(Vec2 a) { return dot(a, a); }
inline Real length(Vec2 a) { return std::sqrt(dot(a, a)); }

/// a scaled to unit length; the zero vector stays zero.
inline Vec2 normalized(Vec2 a) {
  const Real l = length(a);
  return l > 0 ? a / l : Vec2{};
}

constexpr Vec2 min(Vec2 a, Vec2 b) { return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y}; }
constexpr Vec2 max(Vec2 a, Vec2 b) { return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y}; }
constexpr Real clamp(Real x, Real low, Real high) { return x < low ? low : (x > high ? high : x); }

struct SinCos {
  Real sin = 0;
  Real cos = 1;
};
/// Sine and cosine computed from + - * / alone, so the bits are the same with every compiler and standard library.
/// Not a number if the angle (rad) is not finite.
SinCos sin_cos(Real angle);

/// A rotation stored as cosine and sine of its angle; the matrix with columns (c, s) and (-s, c).
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

/// A 2x2 matrix by columns: m * v = v.x * m.x + v.y * m.y.
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
  /// The solution u of m u = b; zero if the matrix is singular.
  constexpr Vec2 solve(Vec2 b) const {
    const Real d = determinant();
    if (d == 0) return {};
    return {cross(b, y) / d, cross(x, b) / d};
  }
};

/// A frame: rotate by q, then translate by p (m).
struct Pose {
  Vec2 p;
  Rotation q;
};

constexpr Vec2 to_world(const Pose& pose, Vec2 local) { return pose.p + pose.q * local; }
constexpr Vec2 to_local(const Pose& pose, Vec2 world) { return pose.q.inverse() * (world - pose.p); }

/// Frame b as seen from frame a. Two shapes can then be collided in the frame of one of them.
constexpr Pose relative(const Pose& a, const Pose& b) { return {to_local(a, b.p), a.q.inverse() * b.q}; }

/// An axis-aligned bounding box.
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

/// The bounds of a rotated box.
inline Aabb box_bounds(Vec2 center, Rotation rotation, Vec2 half_extents) {
  const Real c = std::abs(rotation.c);
  const Real s = std::abs(rotation.s);
  const Vec2 half{c * half_extents.x + s * half_extents.y, s * half_extents.x + c * half_extents.y};
  return {center - half, center + half};
}

}  // namespace impulse::inline IMPULSE_PRECISION
