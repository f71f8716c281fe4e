#pragma once

#include <span>
#include <vector>

#include "reference/simulation.h"

/// Bodies at rest, and how their weight is distributed over their supports.
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

}  // namespace plumb
