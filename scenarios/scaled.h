#pragma once

#include "scenarios/scene/scene.h"

namespace plumb {

/// The same scene with every length `factor` times as long in the same time, masses as they were: every engine's
/// answer must be `factor` times as large, angles alike, but for what it fixes in metres (slops, skins, thresholds).
Scene scaled(const Scene&, double factor);

}  // namespace plumb
