#pragma once

#include <cmath>

/// A four-bar linkage: crank, coupler and rocker between two pivots.
namespace plumb::four_bar {

constexpr double crank = 0.4, coupler = 1, rocker = 0.8, base = 1;  // m, from pin to pin; the pivots are level

// Grashof (1883): the crank turns all round if it is the shortest, and with the longest no longer than the others.
static_assert(crank + base <= coupler + rocker);

struct Pose {
  double crank_angle, coupler_angle,
      rocker_angle;                  // rad: the coupler's from the crank's pin, the rocker's from its pivot
  double coupler_rate, rocker_rate;  // of the crank's rate
};

/// The loop a e^(i t) + b e^(i s) = d + c e^(i r) (Freudenstein 1955), the coupler above its diagonal: from the
/// triangle of coupler, rocker and diagonal; its derivative, across the rocker and across the coupler, tells the rates.
inline Pose pose(double angle) {
  const double along = base - crank * std::cos(angle);
  const double up = -crank * std::sin(angle);
  const double diagonal = std::hypot(along, up);
  const double corner = (coupler * coupler + diagonal * diagonal - rocker * rocker) / (2 * coupler * diagonal);
  const double s = std::atan2(up, along) + std::acos(corner);
  const double r = std::atan2(coupler * std::sin(s) - up, coupler * std::cos(s) - along);
  return {angle, s, r, -crank * std::sin(angle - r) / (coupler * std::sin(s - r)),
          crank * std::sin(angle - s) / (rocker * std::sin(r - s))};
}

}  // namespace plumb::four_bar
