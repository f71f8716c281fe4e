#pragma once

#include <array>
#include <span>
#include <vector>

#include "impulse/math.h"
#include "impulse/shape.h"

namespace impulse::inline IMPULSE_PRECISION {

/// An edge of a convex, counter-clockwise outline.
struct Edge {
  Vec2 from, to;
  Vec2 normal;        // unit, out of the shape
  int first, second;  // indices of the vertices at `from` and `to`
  Real radius;        // m, the surface lies this far out from the edge
};

/// The vertices and normals of a convex shape, in any frame.
struct Hull {
  int count = 0;
  Real radius = 0;
  Vec2 centroid;
  std::array<Vec2, Shape::max_vertices> vertices;
  std::array<Vec2, Shape::max_vertices> normals;

  Edge edge(int i) const;
};

/// In the shape's own frame.
Hull hull_of(const Shape& shape);
/// In the frame in which the shape's frame has this pose.
Hull hull_of(const Shape& shape, const Pose& pose);

/// A face of one hull as a separating axis to another. Ignores the radii.
struct Face {
  int edge = 0;
  int support = 0;      // the other hull's vertex that is deepest below the face
  Real separation = 0;  // m
};
Face face_against(const Hull& hull, int edge, const Hull& other);
/// The face with the greatest separation.
Face best_face(const Hull& hull, const Hull& other);

/// Of the two edges at a vertex, the one that faces against `normal` the most.
int edge_against(const Hull& hull, int vertex, Vec2 normal);

/// The corners of the convex hull, counter-clockwise from the leftmost, independent of the points' order. Omits corners
/// that are collinear with their neighbours up to rounding; collinear points give fewer than 3 corners.
std::vector<Vec2> convex_hull(std::span<const Vec2> points);

/// The width of a convex polygon (m): the least distance between two parallel lines that enclose it.
Real width(std::span<const Vec2> polygon);

/// The greatest distance between two of the points (m).
Real diameter(std::span<const Vec2> points);

}  // namespace impulse::inline IMPULSE_PRECISION
