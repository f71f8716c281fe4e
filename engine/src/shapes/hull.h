#pragma once

#include <array>

#include "impulse/shape.h"
#include "shapes/edges.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A convex shape with vertices, seen from some frame.
struct Hull {
  int count = 0;
  Real radius = 0;
  Vec2 centroid;
  std::array<Vec2, Shape::max_vertices> vertices;
  std::array<Vec2, Shape::max_vertices> normals;

  Edge edge(int i) const;
};

/// In its own frame.
Hull hull_of(const Shape& shape);
/// In the frame that sees the shape's frame at `pose`.
Hull hull_of(const Shape& shape, const Pose& pose);

/// How well a face of one hull separates it from another (cores only, radii apart), and the face that does so best.
struct Face {
  int edge = 0;
  int support = 0;  // the other hull's vertex that is deepest below the face
  Real separation = 0;
};
Face face_against(const Hull& hull, int edge, const Hull& other);
Face best_face(const Hull& hull, const Hull& other);

/// Of the two edges at a vertex, the one that faces a normal.
int edge_against(const Hull& hull, int vertex, Vec2 normal);

}  // namespace impulse::inline IMPULSE_PRECISION
