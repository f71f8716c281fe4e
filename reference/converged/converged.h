#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/simulation.h"

/// A truth by refinement, for scenes without a closed form: an engine, run repeatedly with half the step until its
/// answers agree. The scene is doubled in size each time, so that the lengths that the engine fixes in metres vanish as
/// well. One engine cannot confirm its own convergence: confirmed_truth asks a second one.
namespace plumb {

/// Half-widths of the intervals that should contain the true state.
struct StateError {
  double position = 0;          // m
  double angle = 0;             // rad
  double velocity = 0;          // m/s
  double angular_velocity = 0;  // rad/s
};

struct Refinement {
  const Engine* engine = nullptr;  // null: ours, in double precision
  Settings settings = {};          // that differ from the engine's defaults
  double dt = 1.0 / 60;            // s, step of the coarsest answer
  int halvings = 5;                // at most, and at least `fewest_halvings`
  double tolerance = 1e-3;         // largest error of a pose that counts as converged, as a share of the smallest body
  std::size_t budget = 1e6;        // body-steps of all answers together
};
constexpr int fewest_halvings = 3;  // gives two ratios of successive differences

class Converged {
 public:
  /// Solves the scene at these times, s, ascending from 0 on. If the budget is too small for the fewest halvings up to
  /// the last time, it ends earlier. Throws std::domain_error with the reason if the engine cannot run the scene;
  /// std::invalid_argument for times that are missing, negative or out of order.
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

  /// Checks this answer by another of the same scene at the same times, at one of them. Raises the errors to what the
  /// difference beyond the other's own error shows. Returns the body whose pose is then no longer known within the
  /// tolerance; nullopt if there is none.
  std::optional<std::size_t> contradicted_by(const Converged& other, std::size_t time_index);
  /// Ends it before a time, for a reason.
  void end_before(std::size_t time_index, std::string reason);

 private:
  using Answers = std::vector<std::vector<BodyState>>;  // coarsest first, each time by time

  Answers refine(const Scene&, const Refinement&);
  bool is_promising(const Scene&, std::size_t moment, int halvings, const Answers&);
  void extrapolate(const Scene&, const Answers&, const Refinement&);
  bool is_known(const StateError&) const;

  std::vector<double> times_;
  std::size_t bodies_ = 0;
  double size_ = 0;                // m, of the smallest body
  double tolerance_ = 0;           // m
  std::vector<BodyState> states_;  // time by time
  std::vector<StateError> errors_;
  double valid_until_ = 0;
  std::string reason_;
};

/// The same behind the interface of a closed form. Between its times it is interpolated linearly.
struct ConvergedTruth {
  Engine engine;  // supports no scene if the refinement was refused or is not valid beyond the start
  std::shared_ptr<const Converged> answer;  // null if it was refused
  std::string confirmed_by = "";            // the engines that converge to the same; "" if none was asked
};
ConvergedTruth converged_truth(const Scene&, std::vector<double> times, const Refinement&);
/// Of an answer that may throw std::domain_error when it is asked for.
ConvergedTruth truth_of(const std::function<std::shared_ptr<const Converged>()>&);

/// A second engine is heard while it knows every pose within this share of the smallest body.
inline constexpr double second_share = 0.05;

/// The answer of our engine up to the first of these, which its reason states: it does not converge (a horizon, or an
/// order of impacts that the step decides), its budget ends, no other engine is converged any longer, or one that is
/// contradicts it. A second engine that has not converged has nothing to say; one that has and disagrees ends the
/// truth, and what they differ by beyond its own error counts as an error of the first. Each engine has the budget of
/// the first.
ConvergedTruth confirmed_truth(const Scene&, std::vector<double> times, const Refinement& first);

}  // namespace plumb
