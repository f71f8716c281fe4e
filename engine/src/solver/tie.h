#pragma once

#include <cstdint>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What ties two bodies: the least that must be known of a contact to sort it.
struct Tie {
  std::uint32_t contact = 0;  // index
  std::uint32_t a = 0, b = 0;
  bool pushes_a = false, pushes_b = false;  // whether the body can be pushed
  bool moves_both = false;                  // whether both stir, so that they share an island
  std::uint8_t points = 0;
  bool discs = false;
  bool smooth = false;  // frictionless, and of discs or what is at rest: it turns nothing
  friend bool operator==(const Tie&, const Tie&) = default;
};

/// One lane of a pile.
struct Slot {
  static constexpr std::uint32_t empty = ~std::uint32_t{0};
  Tie tie{.contact = empty};
  bool web = false;  // see ImpactRow
};

}  // namespace impulse::inline IMPULSE_PRECISION
