#pragma once

#include <string>

#include "reports/trace.h"
#include "scenarios/scenario.h"

namespace plumb {

/// By how much numbers of a run are off by rounding, as far as that is of chance: one standard deviation.
class Rounding {
 public:
  Rounding(const Scene&, const Trace&, const Stepping&);

  /// Of a number in that unit, in that unit; 0 for units that no number of ours has.
  double of(const std::string& unit) const;

 private:
  double position_ = 0, velocity_ = 0, turn_ = 0, spin_ = 0;         // off by: m, m/s, rad, rad/s
  double momentum_ = 0, angular_momentum_ = 0, energy_ = 0;          // kg m/s, kg m^2/s, J
  double energy_share_ = 0, impulse_gap_ = 0, h_ = 1, largest_ = 0;  // of the energy range; N s m; s; m
};

}  // namespace plumb
