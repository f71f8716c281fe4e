#pragma once

#include <span>
#include <vector>

#include "reports/trace.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// How far two answers to one scene lie apart at a moment: RMS over the dynamic bodies.
struct PoseDifference {
  double position = 0;  // m
  double angle = 0;     // rad
};

PoseDifference pose_difference(const Scene&, std::span<const BodyState> a, std::span<const BodyState> b);

/// The same at every recorded moment of `a` up to `until` (s) and to b's end; b is read between its steps where needed.
std::vector<PoseDifference> pose_differences(const Scene&, const Trace& a, const Trace& b, double until);

}  // namespace plumb
