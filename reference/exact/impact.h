#pragma once

#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "reference/exact/flight.h"

/// The impact of one body on an immovable floor.
namespace plumb {

/// A rigid body that meets an immovable obstacle at one point.
struct PointImpact {
  double mass = 0;     // kg
  double inertia = 0;  // kg m^2
  Vec normal;          // unit, out of the obstacle
  Vec arm;             // from the centre of mass to the point, m
  Vec velocity;        // of the centre of mass, m/s
  double spin = 0;     // rad/s
  double friction = 0, restitution = 0;
};

/// The impulse on the body, N s, by Newton's restitution (normal speed times -e) and Coulomb's law (|tangential| <= mu
/// normal). nullopt where the classical laws (Newton, Poisson-Keller, Stronge) disagree: where the slip would stop or
/// reverse while normal and tangential motion are coupled. Also nullopt for a point that does not approach.
std::optional<Vec> impact_impulse(const PointImpact&);

/// A body that flies, hits an endless floor with one corner, and flies on. Valid until the second contact.
class FirstImpact {
 public:
  struct Setup {
    BodyState start;     // of the centre of mass
    double mass = 0;     // kg
    double inertia = 0;  // kg m^2
    Vec gravity;         // m/s^2
    std::vector<Corner> corners;
    Floor floor;
    double friction = 0, restitution = 0;
    double horizon = 0;  // s, the end of the solution
  };

  /// The motion, or why the classical impact laws do not agree on one.
  static std::variant<FirstImpact, std::string> solve(const Setup&);

  BodyState at(double t) const;
  double impact() const { return impact_; }  // s; infinite if it never lands
  double valid_until() const { return until_; }

 private:
  FirstImpact() = default;

  BodyState before_;  // at the start
  BodyState after_;   // just after the impact
  Vec gravity_;
  double impact_ = std::numeric_limits<double>::infinity();
  double until_ = std::numeric_limits<double>::infinity();
};

}  // namespace plumb
