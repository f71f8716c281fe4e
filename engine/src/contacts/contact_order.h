#pragma once

#include <cstdint>

#include "broad_phase/broad_phase.h"
#include "contacts/contact.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Contacts are in order of (body_a, body_b, part_a, part_b): here as two numbers.
struct ContactOrder {
  std::uint64_t bodies;
  std::uint32_t parts;

  explicit ContactOrder(const Contact& c) : ContactOrder(c.body_a, c.body_b, c.part_a, c.part_b) {}
  ContactOrder(const Proxy& a, const Proxy& b) : ContactOrder(a.body, b.body, a.part, b.part) {}
  ContactOrder(std::uint32_t a, std::uint32_t b, std::uint16_t part_a, std::uint16_t part_b)
      : bodies(std::uint64_t{a} << 32U | b), parts(std::uint32_t{part_a} << 16U | part_b) {}
  bool operator<(const ContactOrder& other) const {
    return bodies != other.bodies ? bodies < other.bodies : parts < other.parts;
  }
  bool operator==(const ContactOrder&) const = default;
};

}  // namespace impulse::inline IMPULSE_PRECISION
