#pragma once

#include <cstdint>
#include <vector>

#include "solver/impacts.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Makes the row of a contact for this step; of a row whose contact kept its points only what is new of them. `start`:
/// where each body begins the step.
void renew(ImpactRow& row, const BodySet& bodies, const std::vector<Pose>& start, const std::vector<Contact>& contacts,
           std::uint32_t index);

/// Hands back to its contact what the step made of a row. `offset_scale`: see Island.
void leave(ImpactRow& row, Real offset_scale, std::vector<Contact>& contacts);

}  // namespace impulse::inline IMPULSE_PRECISION
