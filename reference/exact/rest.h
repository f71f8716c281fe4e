#pragma once

#include <span>
#include <vector>

#include "reference/simulation.h"

namespace plumb {

/// One surface between two bodies of a tower, from its left to its right end, and what presses on it.
struct Bearing {
  std::size_t below = 0, above = 0;  // bodies, by their index in the scene
  Vec left, right;                   // ends of the surface, world frame
  double weight = 0;                 // N, of everything above
  double resultant = 0;              // m, where along left ... right the weight acts
};

/// A tower at rest: nothing moves, and each bearing carries what stands on it. Statics: the pressure is replaced by
/// forces at the two ends of the surface, which the lever rule makes unique. Holds for ever.
class Rest {
 public:
  Rest(std::vector<BodyState> start, std::vector<Bearing> bearings, Vec up);

  void at(double t, std::span<BodyState> out) const;
  void contacts(double t, double dt, std::vector<ContactState>& out) const;

 private:
  std::vector<BodyState> start_;
  std::vector<Bearing> bearings_;
  Vec up_;
};

}  // namespace plumb
