#include "shapes/hull.h"

#include <limits>

namespace impulse::inline IMPULSE_PRECISION {

Edge Hull::edge(int i) const {
  const int next = i + 1 < count ? i + 1 : 0;
  const auto at = static_cast<std::size_t>(i);
  return {vertices[at], vertices[static_cast<std::size_t>(next)], normals[at], i, next, radius};
}

Hull hull_of(const Shape& shape) {
  Hull hull;
  hull.count = shape.count();
  hull.radius = shape.radius();
  hull.centroid = shape.centroid();
  for (int i = 0; i < hull.count; ++i) {
    hull.vertices[static_cast<std::size_t>(i)] = shape.vertex(i);
    hull.normals[static_cast<std::size_t>(i)] = shape.normal(i);
  }
  return hull;
}

Hull hull_of(const Shape& shape, const Pose& pose) {
  Hull hull;
  hull.count = shape.count();
  hull.radius = shape.radius();
  hull.centroid = to_world(pose, shape.centroid());
  for (int i = 0; i < hull.count; ++i) {
    hull.vertices[static_cast<std::size_t>(i)] = to_world(pose, shape.vertex(i));
    hull.normals[static_cast<std::size_t>(i)] = pose.q * shape.normal(i);
  }
  return hull;
}

Face face_against(const Hull& hull, int edge, const Hull& other) {
  const auto at = static_cast<std::size_t>(edge);
  const Vec2 n = hull.normals[at];
  int support = 0;
  Real lowest = std::numeric_limits<Real>::infinity();
  for (int j = 0; j < other.count; ++j) {
    const Real height = dot(n, other.vertices[static_cast<std::size_t>(j)]);
    if (height < lowest) {
      lowest = height;
      support = j;
    }
  }
  return {edge, support, lowest - dot(n, hull.vertices[at])};
}

Face best_face(const Hull& hull, const Hull& other) {
  Face best{0, 0, -std::numeric_limits<Real>::infinity()};
  for (int i = 0; i < hull.count; ++i) {
    const Face face = face_against(hull, i, other);
    if (face.separation > best.separation) best = face;
  }
  return best;
}

int edge_against(const Hull& hull, int vertex, Vec2 normal) {
  const int before = vertex > 0 ? vertex - 1 : hull.count - 1;
  const Real facing_before = dot(normal, hull.normals[static_cast<std::size_t>(before)]);
  const Real facing_after = dot(normal, hull.normals[static_cast<std::size_t>(vertex)]);
  return facing_before < facing_after ? before : vertex;
}

}  // namespace impulse::inline IMPULSE_PRECISION
