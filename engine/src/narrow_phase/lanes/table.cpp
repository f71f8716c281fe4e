#include "core/simd.h"
#include "solver/lanes/kernels.h"

#ifdef IMPULSE_LANES_avx512
namespace impulse::inline IMPULSE_PRECISION::avx2 {
FindOverlaps find_overlaps;
AnswerQuestions answer_questions;
KeepPoints keep_points;
}
#endif

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

#ifdef IMPULSE_LANES_avx512
// Its ranges hold a few: eight at a time suit them better than sixteen.
using avx2::answer_questions;
using avx2::find_overlaps;
// Gathers more than it computes.
using avx2::keep_points;
#else
FindOverlaps find_overlaps;
AnswerQuestions answer_questions;
KeepPoints keep_points;
#endif
FilterPairs filter_pairs;
CollidePairs collide_boxes;
CollidePairs collide_discs;
CollidePairs collide_disc_with_box;
CollidePairs collide_box_with_disc;
FindFast find_fast;
TurnToAngles turn_to_angles;

extern const Kernels table;
const Kernels table{find_overlaps,         answer_questions,      filter_pairs, collide_boxes, collide_discs,
                    collide_disc_with_box, collide_box_with_disc, find_fast,    keep_points,   turn_to_angles};

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
