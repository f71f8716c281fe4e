#pragma once

#include <cstddef>
#include <optional>

#include "reports/trace.h"
#include "scenarios/scenario.h"

namespace plumb {

/// How far two runs may differ and count as the same.
struct SameEnough {
  double position = 0;  // m, of points and separations too
  double angle = 0;     // rad, of normals too
  double velocity = 0;  // m/s
  double spin = 0;      // rad/s
  double impulse = 0;   // N s
};

/// The same number for all, in each one's own unit; an impulse, N s, counts by the speed it gives the lightest body.
SameEnough within(double tolerance, const Scene&);

/// What round-off explains, from what two runs state of their arithmetic and the largest numbers they met so far.
class RoundOff {
 public:
  RoundOff(const Scene&, const Stepping& a, const Stepping& b);

  /// Takes in what both recorded at a moment; moments are given in turn. `time` in s.
  SameEnough at(double time, std::span<const BodyState> a, std::span<const BodyState> b);

 private:
  void meet(std::span<const BodyState>);

  const Scene& scene_;
  Stepping a_, b_;
  double mass_ = 0;                                     // kg, of all dynamic bodies
  double short_ = 1, long_ = 0;                         // m, radii of gyration
  double place_ = 0, turn_ = 0, speed_ = 0, spin_ = 0;  // the largest so far: m, rad, m/s, rad/s
};

}  // namespace plumb
