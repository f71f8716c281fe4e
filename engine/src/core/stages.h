#pragma once

#include "impulse/real.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Where the time of a step goes, for those who make it faster: compiled with IMPULSE_STAGES, a program tells at its
/// end on standard error what each stage cost; without, nothing of this is there. Stages are told apart by the thread
/// that steps.
#ifdef IMPULSE_STAGES

/// A step begins: what passed since the last stage is nobody's.
void start_stages();
/// What passed since the stage before was this one. The name must live on.
void end_stage(const char* name);

#else

inline void start_stages() {}
inline void end_stage(const char* /*name*/) {}

#endif

}  // namespace impulse::inline IMPULSE_PRECISION
