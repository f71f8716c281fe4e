#pragma once

#include <string>

#include "scenarios/parts.h"
#include "scenarios/random.h"

/// Grains of a granular medium, as several ensembles have them.
namespace plumb::ensembles {

struct Grains {
  double radius = 0;  // m, on average
  double spread = 0;  // of the radii, either way, relative
  Surface surface;

  Body grain(Random& random, std::string name, Vec at) const {
    return disc(std::move(name), at, radius * random.between(1 - spread, 1 + spread), surface);
  }

  /// Loose rows above y = 0, `across` wide about x = 0, of that many grains.
  void pour(Scene& scene, Random& random, double across, int count) const {
    const double cell = 2.1 * radius * (1 + spread);
    const int columns = static_cast<int>(across / cell);
    for (int i = 0; i < count; ++i) {
      const double play = cell / 2 - radius * (1 + spread);
      const Vec at{(i % columns - (columns - 1) / 2.0) * cell + random.between(-play, play),
                   (i / columns + 0.5) * cell + random.between(-play, play)};
      scene.bodies.push_back(grain(random, "grain " + std::to_string(i + 1), at));
    }
  }
};

}  // namespace plumb::ensembles
