#pragma once

#include "impulse/settings.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Whether the chosen solver is told what a body may hit within the step, so that none passes by, with continuous
/// collision or without. Throws std::invalid_argument for settings that validate() refuses.
bool looks_ahead(const Settings&);

}  // namespace impulse::inline IMPULSE_PRECISION
