#pragma once

#include <vector>

#include "scenarios/scene/scene.h"

namespace plumb {

/// The surface between two neighbours of a chain of stones.
struct BedJoint {
  Vec from, to;
  Vec forward;  // unit normal, towards the later neighbour
};

/// A chain of rigid stones laid dry between two abutments. Stone k lies between joints k and k + 1. A joint transmits
/// only a push, between its ends and within its friction cone.
class Arch {
 public:
  struct Stone {
    Vec center;  // m
    Vec weight;  // N
  };

  /// Needs one more joint than stones.
  Arch(std::vector<BedJoint> joints, std::vector<Stone> stones, double friction);

  /// Whether some line of thrust stays within all joints. By the safe theorem of limit analysis the arch then stands,
  /// unless a joint slides first.
  bool stands() const;

 private:
  std::vector<BedJoint> joints_;
  std::vector<Stone> stones_;
  double friction_;
};

}  // namespace plumb
