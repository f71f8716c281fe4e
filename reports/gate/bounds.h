#pragma once

#include <string>

#include "reports/gate/baseline.h"
#include "reports/run/experiment.h"
#include "reports/trace.h"

/// How far a number may differ on another platform.
namespace plumb {

/// Sets the bound of every number of those runs of a baseline that belong to the plan: from runs with perturbed starts
/// and from an estimate of rounding. Takes about sixteen times as long as the runs themselves.
void find_bounds(const Plan&, Baseline&, const Progress&);

/// Estimates the rounding error of the numbers of a run: one standard deviation of what is random in it.
class Rounding {
 public:
  Rounding(const Scene&, const Trace&, const Stepping&);

  /// Of a number with this unit, in this unit; 0 for units that none of our numbers has.
  double of(const std::string& unit) const;

 private:
  double position_ = 0, velocity_ = 0, turn_ = 0, spin_ = 0;         // m, m/s, rad, rad/s
  double momentum_ = 0, angular_momentum_ = 0, energy_ = 0;          // kg m/s, kg m^2/s, J
  double energy_share_ = 0, impulse_gap_ = 0, h_ = 1, largest_ = 0;  // of the energy range; N s m; s; m
};

}  // namespace plumb
