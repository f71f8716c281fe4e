#pragma once

#include <cstddef>
#include <vector>

#include "bodies/body_set.h"
#include "solver/impacts.h"
#include "solver/island.h"
#include "solver/motion.h"

namespace impulse::inline IMPULSE_PRECISION {

/// All contacts of a small island, solved together instead of one after another. So the order in which they are listed
/// says nothing, and no load needs several sub-steps to pass through the island.
///
/// With the impulses j of all points along their normals, one of each contact along its tangent, and K the inverse
/// effective masses between every two, the velocities after a stage are v + K j, and
///
///   j_n >= 0, w_n >= 0, one of them 0               at each point, w_n = v_n + bias + give j_n as in ScalarContacts
///   v_t = 0 if |j_t| <= mu sum j_n, or else j_t = -+mu sum j_n against the sliding            at each contact
///
/// Once it is known which points press and which contacts slip, that is a linear system; which do follows from its
/// solution, and so on until no law is broken: Newton's method for nonsmooth equations (P. Alart and A. Curnier, A
/// mixed formulation for frictional contact problems prone to Newton like solution methods, 1991). Where the masses do
/// not say how points share a load, the impulses change least.
class ContactSystem {
 public:
  enum class Stage { press_soft, press_rigid, relax };

  /// Solves a stage of a sub-step. False, with nothing changed, if Newton's method finds no solution, or bodies are so
  /// deep in each other that what pushes them apart says more than any law.
  bool solve(const Island& island, Stage stage, BodySet& bodies, const std::vector<Motion>& motion);

 private:
  static constexpr std::size_t none = ~std::size_t{0};

  /// Where an unknown impulse acts: along the axis, on b and back on a.
  struct Unknown {
    std::uint32_t a = 0, b = 0;
    InverseMass mass_a, mass_b;
    Vec2 axis;
    Real arm_a = 0, arm_b = 0;

    Real along(const Unknown& other) const;
  };
  /// A point, whose unknown has its index.
  struct Point {
    RowPoint* row = nullptr;
    Real give = 0;  // 1/kg
    bool presses = false;
  };
  enum class Hold { none, sticks, forward, backward };
  /// The friction of a contact.
  struct Friction {
    ImpactRow* row = nullptr;
    std::size_t first = 0, count = 0;  // of its points
    std::size_t unknown = none;        // none if it has no friction
    Hold hold = Hold::none;
  };

  bool list(const Island& island, Stage stage, BodySet& bodies, const std::vector<Motion>& motion);
  void measure(const BodySet& bodies);
  Real share(const Friction& friction, std::size_t point) const;
  Real load(const Friction& friction) const;
  bool place_friction();
  Real off() const;
  void choose();
  void change(std::size_t unknown, Real by);
  bool newton();
  void apply(BodySet& bodies) const;
  Real mass(std::size_t unknown) const;
  Real slope(const Friction& friction) const;
  Real& k(std::size_t i, std::size_t j) { return k_[i * unknowns_.size() + j]; }
  Real k(std::size_t i, std::size_t j) const { return k_[i * unknowns_.size() + j]; }

  std::vector<Point> points_;
  std::vector<Friction> frictions_;
  std::vector<Unknown> unknowns_;  // of the points, then of friction
  std::vector<Real> k_;            // 1/kg, dense
  std::vector<Real> bias_;         // m/s, of each point
  std::vector<Real> impulse_;      // N s, of each unknown
  std::vector<Real> given_;        // N s, what of it the bodies' velocities contain
  std::vector<Real> rate_;         // m/s, w of each unknown
  std::vector<Velocity> before_;   // of the island's bodies
  Real speed_ = 0;                 // m/s, the largest term of a rate: what rounding is measured by

  // The linear system of one round: its unknowns, with the friction that slips as their loads do.
  struct Solved {
    std::size_t unknown = 0;
    std::size_t slips = none;  // unknown
    Real slope = 0;            // its impulse for one of `unknown`
  };
  std::vector<Solved> solved_;
  std::vector<Real> matrix_, right_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
