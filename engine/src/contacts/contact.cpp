#include "contacts/contact.h"

#include <cmath>
#include <limits>

#include "bodies/body_set.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Whether a shape, rotated by q, has a face with this normal.
bool has_face(const Shape& shape, Rotation q, Vec2 normal) {
  constexpr Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  if (shape.type() == ShapeType::circle) return false;
  const int faces = shape.type() == ShapeType::half_space ? 1 : shape.count();
  const Vec2 sought = q.inverse() * normal;
  for (int i = 0; i < faces; ++i) {
    const Vec2 face = shape.normal(i);
    if (std::abs(cross(face, sought)) <= rounding && dot(face, sought) > 0) return true;
  }
  return false;
}

}  // namespace

NormalOf owner(const Contact& contact, const BodySet& bodies) {
  const auto shape = [&](std::uint32_t body, std::uint16_t part) -> const Shape& {
    return bodies.detail[body].parts[part].shape;
  };
  if (has_face(shape(contact.body_a, contact.part_a), contact.found_a.q, contact.normal)) return NormalOf::a;
  if (has_face(shape(contact.body_b, contact.part_b), contact.found_b.q, -contact.normal)) return NormalOf::b;
  return NormalOf::between;
}

}  // namespace impulse::inline IMPULSE_PRECISION
