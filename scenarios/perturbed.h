#pragma once

#include <cstdint>

#include "scenarios/scene/scene.h"

namespace plumb {

/// The same scene with every dynamic body's place moved by up to `size`, m, along either axis, at random; the same for
/// the same seed.
Scene perturbed(const Scene&, double size, std::uint64_t seed);

}  // namespace plumb
