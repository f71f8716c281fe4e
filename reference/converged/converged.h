#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "reference/simulation.h"

/// A reference solution by refinement, for scenes without a closed form: our engine in double precision, run repeatedly
/// with half the step until its answers agree. The scene is doubled in size each time, so that the lengths that the
/// engine fixes in metres vanish as well.
namespace plumb {

/// Half-widths of the intervals that should contain the true state.
struct StateError {
  double position = 0;          // m
  double angle = 0;             // rad
  double velocity = 0;          // m/s
  double angular_velocity = 0;  // rad/s
};

struct Refinement {
  double dt = 1.0 / 60;      // s, step of the coarsest answer
  int halvings = 5;          // at most, and at least `fewest_halvings`
  double tolerance = 1e-3;   // largest error of a pose that counts as converged, as a share of the smallest body
  std::size_t budget = 1e6;  // body-steps of all answers together
};
constexpr int fewest_halvings = 3;  // gives two ratios of successive differences

class Converged {
 public:
  /// Solves the scene at these times, s, ascending from 0 on. Throws std::domain_error with the reason if the engine
  /// cannot run the scene or the budget is too small for the fewest halvings; std::invalid_argument for times that are
  /// missing, negative or out of order.
  Converged(const Scene&, std::vector<double> times, const Refinement& = {});

  const std::vector<double>& times() const { return times_; }
  /// States of all bodies at a time, in Scene order; meaningless after `valid_until`.
  std::span<const BodyState> states(std::size_t time_index) const;
  std::span<const StateError> errors(std::size_t time_index) const;

  /// s, the last of the times up to which the pose of every body is known within the tolerance.
  double valid_until() const { return valid_until_; }
  /// Why it is not valid any longer; "" if it is valid up to the last time.
  const std::string& reason() const { return reason_; }
  /// m, the largest position error up to `valid_until`.
  double largest_error() const;

 private:
  void extrapolate(const Scene&, std::span<const std::vector<BodyState>> answers, const Refinement&);

  std::vector<double> times_;
  std::size_t bodies_ = 0;
  std::vector<BodyState> states_;  // time by time
  std::vector<StateError> errors_;
  double valid_until_ = 0;
  std::string reason_;
  int halvings_ = 0;
};

/// The same behind the interface of a closed form. Between its times it is interpolated linearly.
struct ConvergedTruth {
  Engine engine;  // supports no scene if the refinement was refused or is not valid beyond the start
  std::shared_ptr<const Converged> answer;  // null if it was refused
};
ConvergedTruth converged_truth(const Scene&, std::vector<double> times, const Refinement&);

}  // namespace plumb
