#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/integrate.h"

/// A disc that slides or rolls off a fixed round body, or off an edge, which is one without a radius.
namespace plumb {

struct RollsOff {
  double gravity = 0;   // m/s^2
  double around = 0;    // m, between the centres while they touch
  double radius = 0;    // m, of the disc
  double friction = 0;  // of both

  /// Angle of the line of centres from the vertical, its rate, and the disc's clockwise spin.
  using State = std::array<double, 3>;

  double load(const State& y) const { return gravity * std::cos(y[0]) - around * y[1] * y[1]; }  // N/kg
  bool sticks(const State& y) const { return gravity * std::sin(y[0]) / 3 <= friction * load(y); }

  State rate(const State& y, bool rolling) const {
    const double pull = gravity * std::sin(y[0]);
    const double force = rolling ? pull / 3 : friction * load(y);
    return {y[1], (pull - force) / around, 2 * force / radius};
  }

  struct Left {
    double time = 0;  // s
    State state{};
  };

  /// Until a moment, or until nothing presses the disc on. A smooth disc that starts at rest leaves at cos = 2/3 cos0,
  /// one that rolled all the way at 4/7 cos0; with a finite friction it slips before, for there the load vanishes and
  /// friction does not. A disc that slips from the start must start without spin.
  Left from(State start, double until) const {
    Left now{0, start};
    bool rolling = sticks(now.state);
    double h = step;
    while (h > 1e-15 && now.time < until) {
      const double takes = std::min(h, until - now.time);
      const State next = runge_kutta(now.state, takes, [&](const State& y) { return rate(y, rolling); });
      const bool slips = rolling && !sticks(next);
      if (load(next) < 0 || slips) {
        h /= 2;
        if (slips && h < 1e-12) {
          rolling = false;
          h = step;
        }
        continue;
      }
      now = {now.time + takes, next};
    }
    return now;
  }

  double growth() const { return std::sqrt(gravity / around); }  // 1/s

  /// rad, by which the angle may be off after a time in which it has reached one, and the rate W at most. a'' = c w^2
  /// sin a, w^2 = g/R, so that errors grow at most as cosh(w t). An engine may be off by
  ///   first   half a step ahead or behind, a lag at the start, and, as forces and tangents are those of up to a step
  ///           earlier or later, w^2 h W in acceleration: h W (|drift| + w t/2);
  ///   gap     gap/R of the angle, and of w^2;
  ///   second  (w h)^2 of the angle and its phase;
  ///   stick   friction that is not known to the share creep/(g t).
  double off(const Stepping& s, double t, double reached, double fastest) const {
    const double w = growth();
    const double grown = std::cosh(w * t);
    const double first = s.h * fastest * std::abs(s.drift) + lag(s) * (lag(s) + s.h) * w * w * grown +
                         (first_order_in_contact(s) ? s.h * fastest * w * t / 2 : 0);
    const double gap = s.contact_gap() / around * (grown + w * t) + friction * s.slop / around;
    const double second = w * s.h * w * s.h * (reached + fastest * t);
    return first + gap + second + s.creep * t / around + round_off(s, t, 1 + fastest * t) * grown;
  }

 private:
  static constexpr double step = 1e-4;  // s, of the integration
};

}  // namespace plumb
