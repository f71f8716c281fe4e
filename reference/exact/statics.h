#pragma once

#include <span>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scene/scene.h"

/// Bodies at rest: how their weight is distributed over their supports, and whether these can bear it.
namespace plumb {

/// A beam at rest on two supports: the reactions follow from the lever rule (Archimedes). Valid for ever.
class Beam {
 public:
  /// weight in N; left and right in m from its centre to the supports, both positive.
  Beam(double weight, double left, double right);

  double left() const { return left_; }    // N, reaction of the left support
  double right() const { return right_; }  // N

 private:
  double left_, right_;
};

/// The surface between two bodies of a tower, and the weight on it.
struct SupportSurface {
  std::size_t below = 0, above = 0;  // indices of the bodies in the scene
  Vec left, right;                   // ends of the surface, world frame
  double weight = 0;                 // N, of everything above
  double resultant = 0;              // m from `left` towards `right`, where the weight acts
};

/// A tower at rest: nothing moves, and each surface carries the weight above it. The pressure is replaced by forces at
/// the two ends of the surface, which the lever rule determines. Valid for ever.
class RestingTower {
 public:
  RestingTower(std::vector<BodyState> start, std::vector<SupportSurface> surfaces, Vec up);

  void at(double t, std::span<BodyState> out) const;
  void contacts(double t, double dt, std::vector<ContactState>& out) const;

 private:
  std::vector<BodyState> start_;
  std::vector<SupportSurface> surfaces_;
  Vec up_;
};

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
