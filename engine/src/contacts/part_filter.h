#pragma once

#include <cstddef>

#include "bodies/body_set.h"
#include "impulse/contact.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Whether the world's filter, which may be empty, lets two parts collide. It sees them in the order of contacts.
inline bool accepts(const PartFilter& filter, const BodySet& bodies, std::size_t body_a, std::size_t part_a,
                    std::size_t body_b, std::size_t part_b) {
  if (!filter) return true;
  const PartId a{bodies.id(body_a), static_cast<std::uint16_t>(part_a)};
  const PartId b{bodies.id(body_b), static_cast<std::uint16_t>(part_b)};
  return body_a < body_b ? filter(a, b) : filter(b, a);
}

}  // namespace impulse::inline IMPULSE_PRECISION
