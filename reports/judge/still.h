#pragma once

#include <span>

#include "reference/simulation.h"
#include "scenarios/scene/scene.h"

namespace plumb {

// Slower than this a body looks still: it needs a second for a centimetre.
inline constexpr double still_speed = 0.01;  // m/s
inline constexpr double still_spin = 0.01;   // rad/s

bool is_still(const BodyState&);

/// How many of the dynamic bodies are still.
double still_bodies(const Scene&, std::span<const BodyState>);

}  // namespace plumb
