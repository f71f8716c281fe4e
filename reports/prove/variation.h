#pragma once

#include <cstdint>
#include <string>

#include "reports/run/run.h"

namespace plumb {

/// What may be otherwise in a run of the right engine, while every truth and invariant is what it was: precision,
/// threads, lanes, broad phase, and the seed of scenes that are made at random.
struct Variation {
  std::uint64_t seed = 0;
  Settings settings;  // of our engine

  /// The case with that seed where its scene is made at random; else as it is.
  Case of(const Case&) const;
  /// "seed 3: broad-phase=grid, precision=float, workers=4".
  std::string words() const;
};

Variation variation_of(std::uint64_t seed);

}  // namespace plumb
