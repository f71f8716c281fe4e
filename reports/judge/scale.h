#pragma once

#include <optional>
#include <vector>

#include "reports/judge/observe.h"
#include "scenarios/scenario.h"

/// The scales of a scene: the size of what its truth says changes, in the unit of each quantity. They depend on the
/// scene and its truth alone, so they are the same ruler for every engine.
namespace plumb {

class Scales {
 public:
  /// `truth` may be null: then what changes is known from the start and the expected values only.
  Scales(const Scene&, const Truth* truth);
  /// By a run that is taken for the truth.
  Scales(const Scene&, const Trace&);

  /// The scale of a check with this expected value, > 0. Where the truth changes by less than a hundredth of the floor,
  /// it counts as at rest, and the floor is the scale:
  ///   a position             the size of the body
  ///   an angle               one radian
  ///   a velocity             the speed of a fall by that size or, without gravity, the largest at the start
  ///   an angular velocity    that speed divided by the size
  ///   energy                 see energy_range
  ///   a momentum             that of all bodies at their velocity floors
  ///   a load                 the weight of all bodies
  ///   a time, a spread       the expected value itself
  double of(const Expectation&, double expected) const;

  /// Whether a body moves: the scene gives it a velocity, or the truth, or trace, moves it by more than a hundredth of
  /// its size, or of a radian.
  bool moves() const;

  /// J, of the scene; see energy_range.
  double energy() const { return energy_; }
  /// kg m/s, of the scene: the largest sum of m |v|.
  double momentum() const { return momentum_; }
  /// kg m^2/s, of the scene: the largest sum of m |r| |v| + I |w| about the world's origin.
  double angular_momentum() const { return angular_momentum_; }

 private:
  struct BodyScale {
    double size = 0;          // m, half the extent of a body
    double displacement = 0;  // m, from the start, by the truth
    double turn = 0;          // rad
    double speed = 0;         // m/s, the largest
    double spin = 0;          // rad/s
    double slowest = 0;       // m/s, floor of the speed
  };

  const Scene& scene_;
  std::vector<BodyState> start_;
  std::vector<BodyScale> bodies_;
  double energy_ = 0;            // J
  double momentum_ = 0;          // kg m/s
  double angular_momentum_ = 0;  // kg m^2/s
  double weight_ = 0;            // N
};

}  // namespace plumb
