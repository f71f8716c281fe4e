#pragma once

#include <cstdint>
#include <utility>

#include "contacts/contact.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Names a contact point by the corner of each shape next to it. Two faces that lie on each other have a point at each
/// end of their overlap; whichever of the two corners is the limit there, and whichever shape's face the other is
/// clipped against, the name is the same: it lasts while the same faces meet.
constexpr std::uint32_t feature(int corner_of_a, int corner_of_b) {
  return static_cast<std::uint32_t>(corner_of_a) | static_cast<std::uint32_t>(corner_of_b) << 8;
}

/// The same contact as the other shape sees it.
inline Manifold flipped(Manifold m) {
  m.normal = -m.normal;
  for (ManifoldPoint& p : m.points) p.feature = (p.feature & 0xff) << 8 | p.feature >> 8;
  return m;
}

inline Manifold to_world(const Pose& frame, Manifold m) {
  m.normal = frame.q * m.normal;
  for (ManifoldPoint& p : m.points) p.point = to_world(frame, p.point);
  return m;
}

inline void add(Manifold& m, Vec2 point, Real separation, std::uint32_t feature) {
  m.points[static_cast<std::size_t>(m.count++)] = {point, separation, feature};
}

}  // namespace impulse::inline IMPULSE_PRECISION
