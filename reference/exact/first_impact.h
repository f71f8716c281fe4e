#pragma once

#include <limits>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "reference/exact/first_contact.h"

namespace plumb {

/// A body that flies, hits an endless floor with one corner, and flies on. Holds until the second contact.
class FirstImpact {
 public:
  struct Case {
    BodyState start;  // of the centre of mass
    double mass = 0;  // kg
    double inertia = 0;
    Vec gravity;
    std::vector<Corner> corners;
    Floor floor;
    double friction = 0, restitution = 0;
    double horizon = 0;  // s, after which nobody asks
  };

  /// The motion, or why it has none that the classical impact laws agree on.
  static std::variant<FirstImpact, std::string> solve(const Case&);

  BodyState at(double t) const;
  double impact() const { return impact_; }  // s; infinite if it never lands
  double valid_until() const { return until_; }

 private:
  FirstImpact() = default;

  BodyState before_;  // at the start
  BodyState after_;   // at the impact
  Vec gravity_;
  double impact_ = std::numeric_limits<double>::infinity();
  double until_ = std::numeric_limits<double>::infinity();
};

}  // namespace plumb
