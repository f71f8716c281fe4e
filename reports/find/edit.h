#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "reference/simulation.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// The scene without the bodies begin ... end - 1, their joints and forces.
Scene without_bodies(const Scene&, std::size_t begin, std::size_t end);

/// The scene with its numbers, or those of one body, rounded to so many digits, 1 to 5; directions stay, and rigid rods
/// are as long as their anchors are apart. Nullopt if that is no scene: rounding can make a polygon concave.
std::optional<Scene> with_digits(const Scene&, int digits, std::optional<std::size_t> body = std::nullopt);

/// The scene from a time on, s, at which its run has reached these states.
Scene started_at(const Scene&, std::span<const BodyState>, double time);

}  // namespace plumb
