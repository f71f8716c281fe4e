#pragma once

#include <memory>
#include <optional>
#include <string>

#include "reference/converged/converged.h"
#include "reports/run/run.h"

namespace plumb {

/// The right answer to a case, as far as there is one: its closed form's, else a converged reference's.
class Answer {
 public:
  /// `finest`: s, the smallest step of a run that is to be weighed by it.
  Answer(Case asked, double finest) : asked_(std::move(asked)), finest_(finest) {}

  /// Looks for it, once; before that nothing is known. A converged reference takes its time.
  void find();

  /// Who answers; null where nobody can.
  const Engine* witness() const;
  /// Why nobody can.
  const std::string& reason() const { return reason_; }
  /// s, for how long it holds.
  double until() const { return until_; }
  /// m, largest error that it admits to; 0 of a closed form.
  double error() const { return error_; }

  /// m, by which a run is off: RMS over time and bodies (the metric truth_error_rms).
  double error_of(const Trace&, double dt, double first_step) const;

  /// m, what the round-off of a engine explains.
  double round_off(const Stepping&) const;

 private:
  Case asked_;
  double finest_;
  bool sought_ = false;
  std::optional<ConvergedTruth> converged_;
  const Engine* witness_ = nullptr;
  std::string reason_;
  double until_ = 0;
  double error_ = 0;
  double reach_ = 0;  // m, the farthest from the origin that a body comes, and what its speed makes of the duration
};

}  // namespace plumb
