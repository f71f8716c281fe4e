#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "reference/simulation.h"

/// A truth by refinement, for scenes whose answer no closed form knows: our engine in double, asked again and again
/// with half the step and, so that what it fixes in metres vanishes too, the scene twice as large, until its answers
/// agree.
namespace plumb {

/// Half-widths within which the truth should lie.
struct StateError {
  double position = 0;          // m
  double angle = 0;             // rad
  double velocity = 0;          // m/s
  double angular_velocity = 0;  // rad/s
};

struct Refinement {
  double dt = 1.0 / 60;      // s, of the coarsest answer
  int halvings = 5;          // at most, and at least `fewest_halvings`
  double tolerance = 1e-3;   // of the smallest body: the largest error of a pose that still counts as converged
  std::size_t budget = 1e6;  // body-steps of all answers together
};
constexpr int fewest_halvings = 3;  // two ratios of successive differences

class Converged {
 public:
  /// Answers at these moments, s, ascending from 0 on. Throws std::domain_error, saying why, where the engine cannot
  /// run the scene, or the budget does not even pay for the fewest halvings.
  Converged(const Scene&, std::vector<double> times, const Refinement& = {});

  const std::vector<double>& times() const { return times_; }
  /// Of every body in Scene order; those after `valid_until` say nothing.
  std::span<const BodyState> states(std::size_t moment) const;
  std::span<const StateError> errors(std::size_t moment) const;

  /// s, the last of the moments up to which every body's pose is known within the tolerance.
  double valid_until() const { return valid_until_; }
  /// Why it goes no further; "" when it reaches the last moment.
  const std::string& reason() const { return reason_; }
  int halvings() const { return halvings_; }
  /// m, of all places up to `valid_until`.
  double largest_error() const;

 private:
  void conclude(const Scene&, std::span<const std::vector<BodyState>> answers, const Refinement&);

  std::vector<double> times_;
  std::size_t bodies_ = 0;
  std::vector<BodyState> states_;  // moment-major
  std::vector<StateError> errors_;
  double valid_until_ = 0;
  std::string reason_;
  int halvings_ = 0;
};

/// The same as a truth that takes every closed form's road; read between its moments, it is linear.
struct ConvergedTruth {
  Engine engine;  // supports no scene that was refused, or of which nothing is known beyond the start
  std::shared_ptr<const Converged> answer;  // null where it was refused
};
ConvergedTruth converged_truth(const Scene&, std::vector<double> times, const Refinement&);

}  // namespace plumb
