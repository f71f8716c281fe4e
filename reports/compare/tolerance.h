#pragma once

#include <span>

#include "reports/trace.h"
#include "scenarios/scenario.h"

namespace plumb {

/// How far two runs may differ and still count as equal.
struct StateTolerance {
  double position = 0;  // m, also of contact points and separations
  double angle = 0;     // rad, also of normals
  double velocity = 0;  // m/s
  double spin = 0;      // rad/s
  double impulse = 0;   // N s
};

/// The same number for every quantity, in its own unit; the impulse is what gives the lightest body that velocity.
StateTolerance uniform_tolerance(double tolerance, const Scene&);

/// The differences that round-off explains, from what two runs state of their arithmetic and the largest numbers so
/// far. The scene must outlive it.
class RoundOffTolerance {
 public:
  RoundOffTolerance(const Scene&, const Stepping& a, const Stepping& b);

  /// The tolerance at a time, s, from the states of both runs then and at all earlier calls. Call it moment by moment.
  StateTolerance at(double time, std::span<const BodyState> a, std::span<const BodyState> b);

 private:
  void include(std::span<const BodyState>);

  const Scene& scene_;
  Stepping a_, b_;
  double mass_ = 0;                                  // kg, of all dynamic bodies
  double smallest_radius_ = 1, largest_radius_ = 0;  // m, of gyration
  // The largest so far: m, rad, m/s, rad/s.
  double position_ = 0, angle_ = 0, speed_ = 0, spin_ = 0;
};

}  // namespace plumb
