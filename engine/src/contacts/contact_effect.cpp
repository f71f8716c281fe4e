#include "contacts/contact_effect.h"

#include <cmath>
#include <limits>

namespace impulse::inline IMPULSE_PRECISION {

void ContactEffect::note(const PointArms& at, Vec2 n, Vec2 j) {
  impulse += j.x * n + j.y * perpendicular(n);
  given += length(j);
  turned_a += j.x * at.cross_a + j.y * at.dot_a;
  turned_b += j.x * at.cross_b + j.y * at.dot_b;
}

ContactEffect& ContactEffect::operator+=(const ContactEffect& more) {
  impulse += more.impulse;
  given += more.given;
  turned_a += more.turned_a;
  turned_b += more.turned_b;
  return *this;
}

std::array<Vec2, 2> reported(const ContactEffect& effect, std::array<Vec2, 2> total, const InverseMass& mass_a,
                             const InverseMass& mass_b, Contact& contact) {
  constexpr Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  const Real acted = length(effect.impulse);
  if (acted <= rounding * effect.given) return {};
  const Vec2 sum = total[0] + total[1];
  const Real all = length(sum);
  const auto count = static_cast<std::size_t>(contact.count);
  for (std::size_t i = 0; i < count; ++i) {
    total[i] = all > 0 ? (acted / all) * total[i] : Vec2{acted / static_cast<Real>(count), 0};
  }
  const Vec2 along = all > 0 ? sum : Vec2{1, 0};
  const Vec2 normal = normalized(Rotation(along.x, along.y).inverse() * effect.impulse);
  const bool turned = length(normal - contact.normal) > rounding;
  if (turned) contact.normal = normal;
  const Vec2 tangent = perpendicular(contact.normal);
  const Real pushes = total[0].x + total[1].x;
  Real turned_a = 0;
  Real turned_b = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 world = total[i].x * contact.normal + total[i].y * tangent;
    turned_a += cross(contact.points[i].arm_a, world);
    turned_b += cross(contact.points[i].arm_b, world);
  }
  const auto shift = [&](const InverseMass& mass, Real by) {
    return pushes > 0 && pushable(mass) ? by / pushes : Real{0};
  };
  const Real shift_a = shift(mass_a, turned_a - effect.turned_a);
  const Real shift_b = shift(mass_b, turned_b - effect.turned_b);
  if (!turned && std::abs(shift_a) + std::abs(shift_b) <= rounding) return total;
  contact.forget_place();
  for (std::size_t i = 0; i < count; ++i) {
    contact.points[i].arm_a += shift_a * tangent;
    contact.points[i].arm_b += shift_b * tangent;
  }
  return total;
}

}  // namespace impulse::inline IMPULSE_PRECISION
