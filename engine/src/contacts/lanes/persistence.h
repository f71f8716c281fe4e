#pragma once

#include <cstdint>

#include "contacts/contact.h"
#include "core/instruction_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// How far both bodies of a contact together may move before its points are found anew.
struct PersistenceLimit {
  Real motion = 0;  // m, of any of their points
  Real turn = 0;    // rad; of a disc about its centre it does not count
};

/// Contact persistence: contacts[items[i]], for i below count, keeps its points if its bodies have moved by less than
/// the limit since they were found. Then its separations are measured again and its age is counted up. Writes to
/// kept[i] whether it does. `poses` and `reach` (m, bounding radius) are of all bodies.
using PersistPoints = void(Contact* contacts, const std::uint32_t* items, std::uint32_t count, const Pose* poses,
                           const Real* reach, PersistenceLimit limit, std::uint8_t* kept);

struct ContactKernels {
  PersistPoints* persist_points;
};
const ContactKernels& contact_kernels(InstructionSet set = fastest_instruction_set());

}  // namespace impulse::inline IMPULSE_PRECISION
