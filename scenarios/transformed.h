#pragma once

#include <cstdint>

#include "scenarios/scene/scene.h"

/// Scenes derived from other scenes.
namespace plumb {

/// The same scene with every length multiplied by `factor`, in the same time and with the same masses. The motion
/// should then be `factor` times as large, with equal angles, except for an engine's own lengths (slops, skins,
/// thresholds).
Scene scaled(const Scene&, double factor);

/// The same scene with every dynamic body displaced at random by up to `size`, m, along each axis. The same seed gives
/// the same displacements.
Scene perturbed(const Scene&, double size, std::uint64_t seed);

}  // namespace plumb
