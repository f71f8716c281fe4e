#include "narrow_phase/collide.h"

#include <array>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Shapes without an inside never collide with each other: half-spaces and segments.
Manifold never(const Shape& /*a*/, const Pose& /*pose_a*/, const Shape& /*b*/, const Pose& /*pose_b*/,
               Real /*margin*/) {
  return {};
}

/// A total order of posed shapes: exactly one of in_order(a, b) and in_order(b, a) holds, unless both shapes and poses
/// are equal. The lower one along a slanted direction comes first, so that shapes at rest on each other don't swap when
/// they jitter.
bool in_order(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b) {
  constexpr Vec2 slanted{static_cast<Real>(0.52573), static_cast<Real>(0.85065)};  // the golden ratio as slope
  // Differences first: they change sign exactly when the two are swapped.
  const Vec2 between = (pose_b.p - pose_a.p) + (pose_b.q * b.centroid() - pose_a.q * a.centroid());
  const Real rise = dot(slanted, between);
  if (rise != 0) return rise > 0;
  if (between.x != 0) return between.x > 0;
  if (pose_a.q.c != pose_b.q.c) return pose_a.q.c < pose_b.q.c;
  if (pose_a.q.s != pose_b.q.s) return pose_a.q.s < pose_b.q.s;
  if (a.count() != b.count()) return a.count() < b.count();
  if (a.radius() != b.radius()) return a.radius() < b.radius();
  for (int i = 0; i < a.count(); ++i) {
    if (a.vertex(i).x != b.vertex(i).x) return a.vertex(i).x < b.vertex(i).x;
    if (a.vertex(i).y != b.vertex(i).y) return a.vertex(i).y < b.vertex(i).y;
  }
  return true;
}

struct Cell {
  Collider* collider = nullptr;
  bool filled = false;  // under UBSan, gcc does not accept a comparison with null as a constant
};
using Table = std::array<std::array<Cell, shape_type_count>, shape_type_count>;

// For entries below the diagonal.
template <Collider collider>
Manifold swapped(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  return flipped(collider(b, pose_b, a, pose_a, margin));
}

// For entries on the diagonal: rounding must not depend on which of the two shapes is called a.
template <Collider collider>
Manifold ordered(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  if (in_order(a, pose_a, b, pose_b)) return collider(a, pose_a, b, pose_b, margin);
  return flipped(collider(b, pose_b, a, pose_a, margin));
}

template <Collider collider>
constexpr void enter(Table& table, ShapeType a, ShapeType b) {
  const auto row = static_cast<std::size_t>(a);
  const auto column = static_cast<std::size_t>(b);
  table[row][column] = {row == column ? ordered<collider> : collider, true};
  if (row != column) table[column][row] = {swapped<collider>, true};
}

constexpr Table make_table() {
  using enum ShapeType;
  Table table{};
  enter<circle_circle>(table, circle, circle);
  enter<circle_box>(table, circle, box);
  enter<circle_polygon>(table, circle, polygon);
  enter<circle_capsule>(table, circle, capsule);
  enter<circle_segment>(table, circle, segment);
  enter<circle_half_space>(table, circle, half_space);
  enter<box_box>(table, box, box);
  enter<hull_hull>(table, box, polygon);
  enter<hull_hull>(table, box, capsule);
  enter<hull_segment>(table, box, segment);
  enter<hull_half_space>(table, box, half_space);
  enter<hull_hull>(table, polygon, polygon);
  enter<hull_hull>(table, polygon, capsule);
  enter<hull_segment>(table, polygon, segment);
  enter<hull_half_space>(table, polygon, half_space);
  enter<hull_hull>(table, capsule, capsule);
  enter<hull_segment>(table, capsule, segment);
  enter<hull_half_space>(table, capsule, half_space);
  enter<never>(table, segment, segment);
  enter<hull_half_space>(table, segment, half_space);
  enter<never>(table, half_space, half_space);
  return table;
}

constexpr bool full(const Table& table) {
  for (const auto& row : table) {
    for (const Cell& cell : row) {
      if (!cell.filled) return false;
    }
  }
  return true;
}

constexpr Table colliders = make_table();
static_assert(full(colliders), "every pair of shape types needs a collider, even if it is `never`");

}  // namespace

Manifold collide(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  const Cell& cell = colliders[static_cast<std::size_t>(a.type())][static_cast<std::size_t>(b.type())];
  return cell.collider(a, pose_a, b, pose_b, margin);
}

}  // namespace impulse::inline IMPULSE_PRECISION
