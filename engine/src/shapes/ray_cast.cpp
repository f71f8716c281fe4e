#include <cmath>

#include "impulse/shape.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// The points from + f d, 0 <= f <= 1.
struct Ray {
  Vec2 from;
  Vec2 d;
};

// Keeps the earlier hit; returns whether there is one.
bool keep_first(RayHit& best, bool found, Real fraction, Vec2 normal) {
  if (fraction < 0 || fraction > 1 || (found && fraction >= best.fraction)) return found;
  best.fraction = fraction;
  best.normal = normal;
  return true;
}

// The smaller root of |from + f d - center|^2 = r^2. The form c / (-b + sqrt) avoids cancellation if the ray starts far
// away or close to the surface.
bool enter_disc(const Ray& ray, Vec2 center, Real radius, bool found, RayHit& best) {
  const Vec2 out = ray.from - center;
  const Real c = length_squared(out) - radius * radius;
  const Real b = dot(out, ray.d);
  if (c < 0 || b >= 0) return found;
  // The component of `out` across the ray, times |d|: c - b^2/d^2 would cancel.
  const Real across = cross(out, ray.d);
  const Real discriminant = radius * radius * length_squared(ray.d) - across * across;
  if (discriminant < 0) return found;
  const Real fraction = c / (-b + std::sqrt(discriminant));
  return keep_first(best, found, fraction, normalized(out + fraction * ray.d));
}

// Enters through the edge from a to b, from the side that its normal points to.
bool enter_edge(const Ray& ray, Vec2 a, Vec2 b, Vec2 normal, bool found, RayHit& best) {
  const Real approach = -dot(ray.d, normal);
  const Real height = dot(ray.from - a, normal);
  if (approach <= 0 || height < 0) return found;
  const Real fraction = height / approach;
  const Vec2 along = b - a;
  const Real position = dot(ray.from + fraction * ray.d - a, along);
  if (position < 0 || position > length_squared(along)) return found;
  return keep_first(best, found, fraction, normal);
}

bool enter_half_space(const Ray& ray, const Shape& shape, RayHit& best) {
  const Real approach = -dot(ray.d, shape.normal(0));
  const Real height = dot(ray.from, shape.normal(0)) - shape.offset();
  if (approach <= 0 || height < 0) return false;
  return keep_first(best, false, height / approach, shape.normal(0));
}

// The last plane that the ray crosses inwards, unless it crosses one outwards before (M. Cyrus and J. Beck 1978).
bool enter_polygon(const Ray& ray, const Shape& shape, RayHit& best) {
  Real enter = -1;
  Real leave = 1;
  Vec2 normal;
  for (int i = 0; i < shape.count(); ++i) {
    const Vec2 n = shape.normal(i);
    const Real approach = -dot(ray.d, n);
    const Real height = dot(ray.from - shape.vertex(i), n);
    if (approach == 0 && height > 0) return false;
    if (approach > 0 && height > enter * approach) {
      enter = height / approach;
      normal = n;
    }
    if (approach < 0 && height > leave * approach) leave = height / approach;
  }
  if (enter < 0 || enter > leave) return false;
  return keep_first(best, false, enter, normal);
}

bool enter_outline(const Ray& ray, const Shape& shape, RayHit& best) {
  const int sides = shape.in_chain() ? 1 : 2;
  bool found = false;
  for (int i = 0; i < sides; ++i) {
    const Vec2 n = shape.normal(i);
    const Vec2 out = shape.radius() * n;
    found = enter_edge(ray, shape.vertex(i) + out, shape.vertex(1 - i) + out, n, found, best);
  }
  if (shape.type() == ShapeType::capsule) {
    for (int i = 0; i < 2; ++i) found = enter_disc(ray, shape.vertex(i), shape.radius(), found, best);
  }
  return found;
}

bool enter(const Ray& ray, const Shape& shape, RayHit& best) {
  switch (shape.type()) {
    case ShapeType::circle:
      return enter_disc(ray, shape.centroid(), shape.radius(), false, best);
    case ShapeType::half_space:
      return enter_half_space(ray, shape, best);
    case ShapeType::box:
    case ShapeType::polygon:
      return enter_polygon(ray, shape, best);
    case ShapeType::capsule:
    case ShapeType::segment:
      return enter_outline(ray, shape, best);
  }
  return false;
}

}  // namespace

bool ray_cast(const Shape& shape, Vec2 from, Vec2 to, RayHit& hit) {
  if (shape.contains(from)) return false;
  const Ray ray{from, to - from};
  RayHit best;
  if (!enter(ray, shape, best)) return false;
  best.point = from + best.fraction * ray.d;
  hit = best;
  return true;
}

}  // namespace impulse::inline IMPULSE_PRECISION
