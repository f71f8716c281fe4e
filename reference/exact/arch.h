#pragma once

#include <vector>

#include "reference/plane.h"

namespace plumb {

/// A surface between two neighbours of a chain, from one end to the other. `forward` is its unit normal, towards the
/// later neighbour.
struct Bed {
  Vec from, to;
  Vec forward;
};

/// A chain of rigid stones laid dry between two abutments. Stone k lies between joints k and k + 1. Joints push only,
/// within their ends and their cone of friction.
class Arch {
 public:
  struct Stone {
    Vec center;  // m
    Vec weight;  // N
  };

  /// One joint more than stones.
  Arch(std::vector<Bed> joints, std::vector<Stone> stones, double friction);

  /// Whether some line of thrust stays within all joints: the safe theorem of limit analysis. It says that the arch
  /// stands where nothing slides first.
  bool stands() const;

 private:
  std::vector<Bed> joints_;
  std::vector<Stone> stones_;
  double friction_;
};

}  // namespace plumb
