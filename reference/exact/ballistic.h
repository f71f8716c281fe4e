#pragma once

#include <span>
#include <vector>

#include "reference/simulation.h"

namespace plumb {

/// Bodies that meet nothing: each falls on Galileo's parabola and keeps its spin. Holds for ever.
class Ballistic {
 public:
  Ballistic(std::vector<BodyState> start, std::vector<Vec> acceleration);

  void at(double t, std::span<BodyState> out) const;

 private:
  std::vector<BodyState> start_;
  std::vector<Vec> acceleration_;  // m/s^2, of each body
};

}  // namespace plumb
