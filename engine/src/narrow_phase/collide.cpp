#include "narrow_phase/collide.h"

#include <array>

#include "narrow_phase/colliders.h"
#include "narrow_phase/manifolds.h"
#include "narrow_phase/order.h"

namespace impulse::inline IMPULSE_PRECISION {

Manifold never(const Shape& /*a*/, const Pose& /*pose_a*/, const Shape& /*b*/, const Pose& /*pose_b*/,
               Real /*margin*/) {
  return {};
}

namespace {

struct Cell {
  Collider* collider = nullptr;
  bool filled = false;  // gcc under UBSan takes no comparison with null for a constant
};
using Table = std::array<std::array<Cell, shape_type_count>, shape_type_count>;

// For the entries below the diagonal.
template <Collider collider>
Manifold swapped(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  return flipped(collider(b, pose_b, a, pose_a, margin));
}

// For the entries on it: what rounding does must not depend on which of the two is called a.
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

constexpr Table table = make_table();
static_assert(full(table), "every pair of shape types needs a collider, be it `never`");

}  // namespace

Manifold collide(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  const Cell& cell = table[static_cast<std::size_t>(a.type())][static_cast<std::size_t>(b.type())];
  return cell.collider(a, pose_a, b, pose_b, margin);
}

}  // namespace impulse::inline IMPULSE_PRECISION
