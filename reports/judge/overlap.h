#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "reports/judge/outline.h"

namespace plumb {

/// Two bodies, the smaller index first, and how deep two of their parts overlap.
struct Overlapping {
  std::size_t a = 0, b = 0;
  double depth = 0;  // m, above zero
};

/// How far bodies reach into each other, from the scene's shapes and the states alone. Pairs that may touch are
/// weighed: layers in common, one at least dynamic, not held together by a joint.
class Overlap {
 public:
  explicit Overlap(const Scene&);

  /// Every overlap of two parts.
  std::vector<Overlapping> all(std::span<const BodyState>) const;

  /// The smallest gap between two bodies, m, negative where they overlap; infinite where one has no shape.
  double gap(std::size_t a, std::size_t b, std::span<const BodyState>) const;

  /// The deepest; of depth 0 when nothing overlaps.
  Overlapping deepest(std::span<const BodyState>) const;

 private:
  struct Part {
    std::size_t body;
    Outline outline;  // about the centre of mass
  };
  bool may_touch(std::size_t a, std::size_t b) const;

  const Scene& scene_;
  std::vector<Part> parts_;
  std::vector<std::pair<std::size_t, std::size_t>> jointed_;  // smaller index first, sorted
};

}  // namespace plumb
