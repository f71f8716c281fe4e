#pragma once

#include <cstdint>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

struct BodySet;
struct Contact;

/// The reference face that determines a contact's normal; `between`: the line between the nearest points.
enum class NormalOf : std::uint8_t { between, a, b };

/// Where the normal of a contact comes from, at the poses in which its points were found.
NormalOf owner(const Contact& contact, const BodySet& bodies);

}  // namespace impulse::inline IMPULSE_PRECISION
