#pragma once

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A profile of the step's stages. Compiled with IMPULSE_STAGES, a program prints at its end, on standard error and per
/// stepping thread, what each stage cost; otherwise these calls compile to nothing.
#ifdef IMPULSE_STAGES

/// Begins a step; the time since the last stage is not counted.
void start_stages();
/// Attributes the time since the previous stage to this one. The name must outlive the program's steps.
void end_stage(const char* name);

#else

inline void start_stages() {}
inline void end_stage(const char* /*name*/) {}

#endif

}  // namespace impulse::inline IMPULSE_PRECISION
