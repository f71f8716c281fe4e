#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenarios/scenario.h"

/// What three engines state about how they step, at 60 steps a second, and what that allows them. Tests of allowances
/// use them to show that a wrong engine fails by the most generous of these statements.
namespace plumb::statement_of {

/// Box2D 2.4: symplectic Euler in float, with skins and sequential impulses.
inline Stepping skinned() {
  Stepping s{.dt = 1.0 / 60, .h = 1.0 / 60, .drift = 0.5, .order = 1, .impact_lag = 1};
  s.skin = 0.02;
  s.slop = s.joint_slop = 0.005;
  s.restitution_threshold = 1;
  s.iterations = 8;
  s.epsilon = 0x1p-24;
  s.spring_limit = 2;
  return s;
}

/// Chipmunk with a slop for metres: positions first, then velocities, in double.
inline Stepping positions_first() {
  Stepping s{.dt = 1.0 / 60, .h = 1.0 / 60, .drift = -0.5, .order = 1, .order_in_contact = 1, .impact_lag = 1};
  s.slop = 0.005;
  s.joint_slop = 10.0 / 3600;
  s.iterations = 10;
  s.epsilon = 0x1p-53;
  s.spring_limit = 2;
  return s;
}

/// Box2D 3: symplectic Euler in sub-steps and float, with contacts that are springs.
inline Stepping soft() {
  Stepping s{.dt = 1.0 / 60, .h = 1.0 / 240, .drift = 0.5, .order = 1, .impact_lag = 8};
  s.contact_frequency = 30;
  s.fixed_contact_frequency = s.joint_frequency = 60;
  s.held_anchors = true;
  s.iterations = 1;
  s.epsilon = 0x1p-24;
  s.spring_limit = 2;
  return s;
}

/// Our own: second order in sub-steps, and impacts at their own time.
inline Stepping accurate() {
  Stepping s{.dt = 1.0 / 60, .h = 1.0 / 240, .order = 2, .order_in_contact = 2, .impact_lag = 0};
  s.skin = s.slop = 0.0005;
  s.joint_slop = 1e-5;
  s.epsilon = 0x1p-53;
  s.spring_limit = 8;
  return s;
}

inline std::vector<Stepping> all() { return {skinned(), positions_first(), accurate()}; }

/// One check of a scenario.
struct Of {
  std::string scenario;
  Parameters changes;
  std::string body;
  Quantity quantity;
  std::optional<double> before = std::nullopt;  // s, only checks at an earlier time
  std::optional<Relation> relation = std::nullopt;

  std::vector<Expectation> expectations() const {
    const Scenario* found = Catalog<Scenario>::find(scenario);
    if (found == nullptr) throw std::logic_error("no scenario " + scenario);
    std::vector<Expectation> matching;
    for (const Expectation& one : found->expectations(complete(*found, changes))) {
      const bool early = !before || (one.time && *one.time < *before);
      if (one.body == body && one.quantity == quantity && early && one.other.empty() &&
          (!relation || one.relation == *relation))
        matching.push_back(one);
    }
    if (matching.empty()) throw std::logic_error(scenario + " checks no such quantity of " + body);
    return matching;
  }

  /// The largest error, in the quantity's unit, with which an engine passes all these checks.
  double allows(const Stepping& stated) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Expectation& one : expectations()) least = std::min(least, one.allowed(stated));
    return least;
  }

  /// The same for the most generous statement.
  double allows_at_most() const {
    double most = 0;
    for (const Stepping& stated : all()) most = std::max(most, allows(stated));
    return most;
  }
};

}  // namespace plumb::statement_of
