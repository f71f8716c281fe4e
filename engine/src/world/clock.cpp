#include "impulse/clock.h"

#include <cmath>
#include <stdexcept>

namespace impulse::inline IMPULSE_PRECISION {

FrameClock::FrameClock(double dt, double longest) : dt_(dt), longest_(longest) {
  if (!(dt > 0) || !(longest >= dt) || !std::isfinite(longest)) {
    throw std::invalid_argument("FrameClock: needs 0 < dt <= longest, both finite (s)");
  }
  if (longest > 1e6 * dt) throw std::invalid_argument("FrameClock: longest is more than a million steps of dt");
}

int FrameClock::advance(double frame_time) {
  if (frame_time > 0) stored_ += frame_time;
  if (stored_ > longest_) stored_ = longest_;
  int steps = 0;
  while (stored_ >= dt_) {
    stored_ -= dt_;
    ++steps;
  }
  return steps;
}

double FrameClock::alpha() const { return stored_ / dt_; }

}  // namespace impulse::inline IMPULSE_PRECISION
