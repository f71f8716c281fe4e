#pragma once

#include <cstdint>

#include "contacts/contact.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Keeps the points of contacts[items[i]], for i below count, where no point of the two bodies has come farther, added
/// up, than `most_motion` (m) since they were found: measures their separations again and counts the step. Says of each
/// whether.
using KeepPoints = void(Contact* contacts, const std::uint32_t* items, std::uint32_t count, const Pose* poses,
                        const Real* reach, Real most_motion, std::uint8_t* kept);

}  // namespace impulse::inline IMPULSE_PRECISION
