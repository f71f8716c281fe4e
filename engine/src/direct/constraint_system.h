#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bodies/body_set.h"

namespace impulse::inline IMPULSE_PRECISION {

inline bool pushable(const InverseMass& mass) { return mass.m + mass.i > 0; }

/// What a constraint demands of its rate w and its impulse j.
enum class Law : std::uint8_t {
  holds,   // w = 0: an equation of a joint
  pushes,  // w >= 0, j >= 0, one of them 0: a point of a contact, the stop of a joint
  drives,  // w = 0 if |j| <= most, or else j = -+most against w: a motor
  rubs     // the same with mu times the load of its points: the friction of a contact
};

/// One scalar constraint between two bodies: an impulse j acts along the axis on b and back on a. Its rate is
///
///   w = axis . (vB - vA) + arm_b wB - arm_a wA + bias + compliance j
struct Constraint {
  std::uint32_t a = 0, b = 0;
  InverseMass mass_a, mass_b;
  Vec2 axis;
  Real arm_a = 0, arm_b = 0;
  Law law = Law::holds;
  Real bias = 0;        // m/s or rad/s
  Real compliance = 0;  // 1/kg or 1/(kg m^2)
  Real impulse = 0;     // N s or N m s, accumulated
  Real given = 0;       // of these, what acted before
  Real most = 0;        // of a motor
  bool acts = false;    // whether it is expected to: a first guess
  bool fixed = false;   // its impulse is not to change

  // Of friction: its points, at most two and in a row, and where it acts if only one of them bears load.
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  Real friction = 0;  // coefficient
  std::array<Real, 2> point_a{}, point_b{}, point_bias{};
};

/// All constraints of a small island, solved together. So their order says nothing, and no load needs several sub-steps
/// to pass through the island.
///
/// Once it is known which points push, which contacts slide and which motors are at their limits, the laws are a linear
/// system; which do follows from its solution, and so on until no law is broken: Newton's method for nonsmooth equations
/// (P. Alart and A. Curnier, A mixed formulation for frictional contact problems prone to Newton like solution methods,
/// 1991). If that goes in circles, sweeps (projected Gauss-Seidel) find other guesses. Where masses do not say how
/// constraints share a load, impulses change least.
class ConstraintSystem {
 public:
  void clear();
  /// Forgets which constraints act.
  void begin_anew() { state_.clear(); }
  std::uint32_t add(const Constraint& constraint);
  std::span<Constraint> all() { return rows_; }
  Constraint& operator[](std::size_t i) { return rows_[i]; }

  /// m/s or rad/s, without bias and compliance.
  static Real speed(const Constraint& row, const std::vector<Velocity>& velocity);

  /// Whether the impulses of the last solve did work, by more than rounding.
  bool drove(const std::vector<Velocity>& velocity) const;

  /// Finds the impulses and applies their changes to the velocities. False if some law is still broken by more than
  /// rounding; impulses then keep to their bounds, as sweeps leave them.
  bool solve(std::vector<Velocity>& velocity);

 private:
  enum class State : std::uint8_t { off, holds, forward, backward };

  void prepare(const std::vector<Velocity>& velocity);
  void weigh(std::size_t i);
  Real rate(std::size_t i, const std::vector<Velocity>& velocity) const;
  void change(std::size_t i, Real by, std::vector<Velocity>& velocity) const;
  void give(std::size_t i, Real by, std::vector<Velocity>& velocity);
  Real load(const Constraint& friction) const;
  Real wanted(std::size_t i, const std::vector<Velocity>& velocity) const;
  Real off(const std::vector<Velocity>& velocity) const;
  bool choose(const std::vector<Velocity>& velocity);
  bool bears(std::size_t point) const;
  void place_friction(std::size_t i, std::vector<Velocity>& velocity);
  bool factor();
  bool newton(std::vector<Velocity>& velocity);
  void sweep(std::vector<Velocity>& velocity);
  void keep(Real off);
  void restore(std::vector<Velocity>& velocity);
  void note_start(const std::vector<Velocity>& velocity);
  void rebuild(std::vector<Velocity>& velocity);

  std::vector<Constraint> rows_;
  std::vector<Real> mass_;            // of each row alone
  std::vector<State> state_;          // of each row
  std::vector<State> last_;           // when the matrix was factored
  Real scale_ = 0;                    // m/s, the largest term of a rate: what rounding is measured by
  std::vector<std::uint32_t> free_;   // rows whose rates are solved for
  std::vector<std::uint32_t> slips_;  // of each of these, the friction that follows its impulse; or none
  std::vector<Real> slope_;           // by how much
  std::vector<Real> matrix_, right_;
  std::vector<std::size_t> pivot_;
  bool factored_ = false;
  Real soft_ = 0;  // compliance of all, as a fraction of their own inverse masses, if they cannot all be rigid
  std::vector<Real> compliance_;
  Real best_off_ = 0;
  std::vector<Real> best_, given_;
  std::vector<std::pair<Velocity, Velocity>> start_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
