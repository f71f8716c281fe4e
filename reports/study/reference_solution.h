#pragma once

#include <memory>
#include <optional>
#include <string>

#include "reference/converged/converged.h"
#include "reports/run/run.h"

namespace plumb {

/// The correct solution of a case, as far as one is known: its closed form, or else a converged reference.
class ReferenceSolution {
 public:
  /// `finest`: s, the smallest step of any run that is compared with it.
  ReferenceSolution(Case problem, double finest) : problem_(std::move(problem)), finest_(finest) {}

  /// Finds the solution; calls after the first do nothing. Must be called before anything else. Computing a converged
  /// reference takes about a second.
  void find();

  /// The engine that gives the solution; null if none does.
  const Engine* engine() const { return engine_; }
  /// Why there is no solution.
  const std::string& reason() const { return reason_; }
  /// s, up to where it is valid.
  double until() const { return until_; }
  /// m, its own largest error; 0 for a closed form.
  double error() const { return error_; }

  /// m, how far the solution takes the bodies from where they start, RMS over time and bodies (RMS as errors are, so
  /// that they compare); at least the smallest body's size, which is what counts where nothing moves.
  double scale() const { return scale_; }

  /// m, the error of a run: RMS over time and bodies (the metric truth_error_rms). Throws std::runtime_error if it
  /// cannot be measured.
  double error_of(const Trace&, double dt, double first_step) const;

  /// m, the error that an engine's round-off explains.
  double round_off(const Stepping&) const;

 private:
  Case problem_;
  double finest_;
  bool searched_ = false;
  std::optional<ConvergedTruth> converged_;
  const Engine* engine_ = nullptr;
  std::string reason_;
  double until_ = 0;
  double error_ = 0;
  double scale_ = 0;   // m
  double extent_ = 0;  // m, the largest of a body's distance from the origin plus its speed times the duration
};

}  // namespace plumb
