#pragma once

#include "scenarios/scene/scene.h"

namespace plumb {

/// How a scene starts against the rules: nothing that an engine should be blamed for.
struct Contradictions {
  double overlap = 0;      // m, the deepest of bodies that may touch
  double joint_speed = 0;  // m/s, at which what joints hold together moves apart
  double joint_gap = 0;    // m, by which a rigid distance joint has another length than its anchors
};

Contradictions contradictions(const Scene&);

/// Whether a scene starts no more against the rules than another, but for round-off.
bool no_worse(const Scene&, const Contradictions& than);

}  // namespace plumb
