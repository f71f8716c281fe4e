#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "reports/outline.h"

namespace plumb {

/// How far bodies reach into each other, from the scene's shapes and the states alone. Pairs that may touch are
/// weighed: layers in common, one at least dynamic, not held together by a joint.
class Overlap {
 public:
  explicit Overlap(const Scene&);

  /// The deepest overlap of any pair, m; 0 when nothing overlaps.
  double deepest(std::span<const BodyState>) const;

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
