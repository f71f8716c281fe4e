#pragma once

#include <cstdint>

#include "contacts/contact.h"
#include "core/instruction_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Contact persistence: contacts[items[i]], for i below count, keeps its points if no point of its two bodies can have
/// moved by a total of `most_motion` (m) or more since they were found. Then its separations are measured again and its
/// age is counted up. Writes to kept[i] whether it does. `poses` and `reach` (m, bounding radius) are of all bodies.
using PersistPoints = void(Contact* contacts, const std::uint32_t* items, std::uint32_t count, const Pose* poses,
                           const Real* reach, Real most_motion, std::uint8_t* kept);

struct ContactKernels {
  PersistPoints* persist_points;
};
const ContactKernels& contact_kernels(InstructionSet set = fastest_instruction_set());

}  // namespace impulse::inline IMPULSE_PRECISION
