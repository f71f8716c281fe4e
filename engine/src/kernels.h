#pragma once

#include <span>

#include "kernels/manifolds.h"
#include "kernels/overlaps.h"
#include "kernels/recycle.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The inner loops that are compiled for several instruction sets (see simd.h).
struct Kernels {
  FindOverlaps* find_overlaps;
  CollidePairs* collide_boxes;
  CollidePairs* collide_discs;
  CollidePairs* collide_disc_with_box;
  CollidePairs* collide_box_with_disc;
  MeasureAgain* measure_again;
};

/// All versions that this processor runs, the slowest first. They give the same bits.
std::span<const Kernels> runnable_kernels();

/// The fastest of them.
inline const Kernels& kernels() { return runnable_kernels().back(); }

}  // namespace impulse::inline IMPULSE_PRECISION
