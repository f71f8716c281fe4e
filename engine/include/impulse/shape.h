#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "impulse/material.h"
#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Always computed from shapes and densities, never set by hand.
struct MassData {
  Real mass = 0;     // kg
  Real inertia = 0;  // kg m^2 about `center`
  Vec2 center;       // of mass, in the frame of the shape's owner
};

enum class ShapeType : std::uint8_t { circle, box, polygon, capsule, segment, half_space };
constexpr int shape_type_count = 6;

/// A convex shape in its body's frame. A value type: copy it freely.
///
/// Every shape except the half-space is the convex hull of `count` vertices, rounded by `radius`: one vertex makes a
/// circle, two a capsule or a segment, more a polygon (vertices counter-clockwise; normal i points out of the edge
/// from vertex i to i+1).
class Shape {
 public:
  static constexpr int max_vertices = 8;
  static constexpr Real unbounded = static_cast<Real>(1e9);  // m

  /// All of these throw std::invalid_argument for sizes that are not positive and finite.
  static Shape circle(Real radius, Vec2 center = {});
  static Shape box(Vec2 half_extents, Vec2 center = {}, Real angle = 0);
  /// The convex hull of the points, in any order. Throws std::invalid_argument for fewer than three distinct points,
  /// for hulls with more than eight vertices, and for hulls thinner than a thousandth of their length.
  static Shape polygon(std::span<const Vec2> points);
  static Shape capsule(Vec2 from, Vec2 to, Real radius);
  static Shape segment(Vec2 from, Vec2 to);
  /// Solid where dot(normal, p) <= offset. The normal need not have unit length: a x + b y + c <= 0 is
  /// half_space({a, b}, -c).
  static Shape half_space(Vec2 normal, Real offset);
  /// Segments through the points that know their neighbours, so that nothing catches on the joins ("ghost collisions").
  /// One-sided, like the outline of a counter-clockwise polygon: solid to the left of the direction of travel, free to
  /// the right, where normal(0) points. Ground with the sky above it therefore runs towards -x. `loop` connects the
  /// last point to the first. Needs two points, or three for a loop; neighbouring points must be distinct.
  static std::vector<Shape> chain(std::span<const Vec2> points, bool loop);

  ShapeType type() const { return type_; }
  int count() const { return count_; }
  Vec2 vertex(int i) const { return vertices_[static_cast<std::size_t>(i)]; }
  Vec2 normal(int i) const { return normals_[static_cast<std::size_t>(i)]; }  // half-space: normal(0), offset()
  Real radius() const { return radius_; }
  Real offset() const { return offset_; }              // half-space only, along the unit normal
  Vec2 half_extents() const { return half_extents_; }  // box only; its x axis is normal(1)
  Vec2 centroid() const { return centroid_; }

  /// Half-spaces are infinite: their bounds extend to `unbounded` in each direction that the boundary does not limit.
  Aabb bounds(const Pose& pose) const;
  /// Throws std::invalid_argument for a density (kg/m^2) that is negative or not finite. Segments and half-spaces have
  /// no mass, so a dynamic body needs another part that has some.
  MassData mass(Real density) const;
  /// The boundary counts as inside; segments contain nothing.
  bool contains(Vec2 local) const;
  Real extent() const;  // m, distance of the farthest point from the frame's origin; `unbounded` for half-spaces
  Shape moved(Vec2 by) const;

  /// Ghost neighbours of a segment in a chain: the vertex before `from` and the one after `to`.
  bool in_chain() const { return in_chain_; }
  /// At a free end of an open chain the ghost is the segment's other end, as if the chain turned back.
  Vec2 ghost_before() const { return ghosts_[0]; }
  Vec2 ghost_after() const { return ghosts_[1]; }

 private:
  static Shape hull(ShapeType type, std::span<const Vec2> vertices, Real radius);

  ShapeType type_ = ShapeType::circle;
  std::uint8_t count_ = 1;
  bool in_chain_ = false;
  Real radius_ = 0;
  Real offset_ = 0;
  Vec2 centroid_;
  Vec2 half_extents_;
  Vec2 given_normal_;  // half-space as given, not normalized, so that contains() is exact
  Real given_offset_ = 0;
  std::array<Vec2, max_vertices> vertices_{};
  std::array<Vec2, max_vertices> normals_{};
  std::array<Vec2, 2> ghosts_{};
};

struct RayHit {
  Real fraction = 1;  // of the ray from `from` to `to`
  Vec2 point;
  Vec2 normal;  // out of the shape
};

/// Finds where the ray from -> to (shape's frame) enters the shape. Returns false if it misses or starts inside. Rays
/// hit a segment from both sides, but a segment of a chain only from its free side.
bool ray_cast(const Shape& shape, Vec2 from, Vec2 to, RayHit& hit);

}  // namespace impulse::inline IMPULSE_PRECISION
