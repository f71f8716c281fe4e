#pragma once

#include "scenarios/scenario.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// How a scene starts against the rules: nothing that an engine should be blamed for.
struct Contradictions {
  double overlap = 0;      // m, the deepest of bodies that may touch
  double joint_speed = 0;  // m/s, at which what joints hold together moves apart
  double joint_gap = 0;    // m, by which a rigid distance joint has another length than its anchors
};

Contradictions contradictions(const Scene&);

Contradictions operator+(const Contradictions&, const Contradictions&);
/// The larger of each.
Contradictions larger(const Contradictions&, const Contradictions&);
/// What an engine states that its runs may leave of them: contacts and joints within their gaps, which a step closes.
Contradictions stated_by(const Stepping&);

/// Whether a scene starts no more against the rules than another, but for round-off.
bool no_worse(const Scene&, const Contradictions& than);

}  // namespace plumb
