#pragma once

#include <span>

#include "broad_phase/lanes/overlaps.h"
#include "narrow_phase/lanes/manifolds.h"
#include "narrow_phase/lanes/recycle.h"
#include "narrow_phase/lanes/rotations.h"
#include "solver/lanes/contact_lanes.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The inner loops that are compiled for several instruction sets (see simd.h): those that find contacts, to the bit as
/// their twins outside do,
struct Kernels {
  FindOverlaps* find_overlaps;
  AnswerQuestions* answer_questions;
  FilterPairs* filter_pairs;
  CollidePairs* collide_boxes;
  CollidePairs* collide_discs;
  CollidePairs* collide_disc_with_box;  // the disc is the first of each pair
  CollidePairs* collide_box_with_disc;
  FindFast* find_fast;
  KeepPoints* keep_points;
  TurnToAngles* turn_to_angles;
};

/// and those that solve piles.
struct PileKernels {
  // One of the two.
  const ContactPasses<8>* contacts_by_eight;
  const ContactPasses<16>* contacts_by_sixteen;
  KickByForces* kick_by_forces;
  KickBodies* kick_bodies;
  DriftBodies* drift_bodies;
};

/// All versions that this processor runs, the slowest first: one number at a time, then by ever larger registers. They
/// give the same bits.
std::span<const Kernels* const> runnable_kernels();
/// The same of piles.
std::span<const PileKernels* const> runnable_pile_kernels();

/// The fastest of them.
inline const Kernels& kernels() { return *runnable_kernels().back(); }
inline const PileKernels& pile_kernels() { return *runnable_pile_kernels().back(); }

}  // namespace impulse::inline IMPULSE_PRECISION
