#include "core/simd.h"
#include "narrow_phase/lanes/manifolds.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

CollidePairs collide_boxes;
CollidePairs collide_discs;
CollidePairs collide_disc_with_box;
CollidePairs collide_box_with_disc;
FindFast find_fast;

extern const NarrowPhaseKernels narrow_phase_table;
const NarrowPhaseKernels narrow_phase_table{collide_boxes, collide_discs, collide_disc_with_box, collide_box_with_disc,
                                            find_fast};

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
