#pragma once

#include <array>

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

}  // namespace impulse::inline IMPULSE_PRECISION
