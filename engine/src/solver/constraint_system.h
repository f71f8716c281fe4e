#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "bodies/body_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What a constraint demands of its rate w and its impulse j.
enum class Law : std::uint8_t {
  holds,   // w = 0: an equation of a joint
  pushes,  // w >= 0, j >= 0, one of them 0: a point of a contact, the stop of a joint
  drives,  // w = 0 if |j| <= most, or else j = -+most against w: a motor
  rubs     // the same with the coefficient times the load of its points: the friction of a contact
};

/// One scalar constraint between two bodies: an impulse j acts along the axis on b and back on a. Its rate is
///
///   w = axis . (vB - vA) + arm_b wB - arm_a wA + bias
struct Constraint {
  std::uint32_t a = 0, b = 0;
  InverseMass mass_a, mass_b;  // none: it takes no part
  Vec2 axis;                   // unit, or 0 for an angle
  Real arm_a = 0, arm_b = 0;   // m, or 1 for an angle
  Law law = Law::holds;
  Real bias = 0;       // m/s or rad/s
  Real impulse = 0;    // N s or N m s: a guess, and the solution
  Real given = 0;      // of these, what the velocities contain before they are solved for
  Real most = 0;       // of a motor
  bool fixed = false;  // its impulse is not to change
  Real place = 0;      // where it acts, by any measure: neighbours are eliminated one after the other

  // Of friction: its points, at most two, which stand before it in a row, and where it acts on each.
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  Real friction = 0;  // coefficient
  std::array<Real, 2> point_a{}, point_b{}, point_bias{};
};

/// All constraints of a small island, solved together. So their order says nothing, and no load needs several sub-steps
/// to pass through the island.
///
/// Once it is known which points push, which contacts slide and which motors are at their limits, the laws are a linear
/// system; which do follows from its solution, and so on until no law is broken: Newton's method for nonsmooth
/// equations (P. Alart and A. Curnier, A mixed formulation for frictional contact problems prone to Newton like
/// solution methods, Comput. Methods Appl. Mech. Eng. 92 (1991)). Where masses do not say how constraints share a load,
/// impulses change least from the guess. If Newton's method goes in circles, the laws are solved as a linear
/// complementarity problem by pivoting, and from there Newton's method goes on.
class ConstraintSystem {
 public:
  void clear();
  std::uint32_t add(const Constraint& constraint);
  std::span<Constraint> all() { return rows_; }
  std::span<const Constraint> all() const { return rows_; }
  Constraint& operator[](std::size_t i) { return rows_[i]; }
  const Constraint& operator[](std::size_t i) const { return rows_[i]; }

  /// Finds the impulses and applies what they have changed by to the velocities, from the guesses on in the first call,
  /// from the last solution in the next ones. False if some law is still broken by more than rounding; impulses keep to
  /// their bounds then, too.
  bool solve(std::vector<Velocity>& velocity);

  /// Forgets the solution: impulses are 0, and velocities as before the first call.
  void undo(std::vector<Velocity>& velocity);
  /// Solves anew which constraints act, after some were fixed or set free.
  void reconsider() { state_.clear(); }
  /// Velocities as before the first call, from which the next one starts with the solution as a guess.
  void restart(std::vector<Velocity>& velocity);

  /// m/s or rad/s, without bias.
  template <class Number = Real>
  static Number speed(const Constraint& row, const std::vector<Velocity>& velocity) {
    const Velocity& a = velocity[row.a];
    const Velocity& b = velocity[row.b];
    const Vec2 v = b.v - a.v;
    return Number{row.axis.x} * Number{v.x} + Number{row.axis.y} * Number{v.y} + Number{b.w} * Number{row.arm_b} -
           Number{a.w} * Number{row.arm_a};
  }
  /// Whether the impulses did work, by more than rounding.
  bool drove(const std::vector<Velocity>& velocity) const;

 private:
  /// A fraction of a constraint's own inverse mass, by which it yields while it is solved for: that decides between
  /// equal ways to share a load. It does not stay: what it leaves is solved in the next round.
  static constexpr Real least_compliance = static_cast<Real>(sizeof(Real) == 8 ? 1e-9 : 1e-4);

  enum class State : std::uint8_t { off, holds, forward, backward };

  /// The change of the rate of p for a unit impulse along q, through the bodies that both act on.
  template <class Number>
  static Number response(const Constraint& p, const Constraint& q) {
    const auto through = [&](const InverseMass& mass, Real arm_p, Real arm_q) {
      const Number along = Number{p.axis.x} * Number{q.axis.x} + Number{p.axis.y} * Number{q.axis.y};
      return Number{mass.m} * along + Number{mass.i} * Number{arm_p} * Number{arm_q};
    };
    Number sum = 0;
    if (p.a == q.a) sum += through(p.mass_a, p.arm_a, q.arm_a);
    if (p.b == q.b) sum += through(p.mass_b, p.arm_b, q.arm_b);
    if (p.a == q.b) sum -= through(p.mass_a, p.arm_a, q.arm_b);
    if (p.b == q.a) sum -= through(p.mass_b, p.arm_b, q.arm_a);
    return sum;
  }
  State guessed_state(const Constraint& row, Real rounding) const;
  void begin(std::vector<Velocity>& velocity);
  void weigh(std::size_t i);
  Real rate(std::size_t i, const std::vector<Velocity>& velocity) const;
  void change(std::size_t i, Real by, std::vector<Velocity>& velocity) const;
  void give(std::size_t i, Real by, std::vector<Velocity>& velocity);
  Real load(const Constraint& friction) const;
  Real wanted(std::size_t i, const std::vector<Velocity>& velocity) const;
  Real broken_by(const std::vector<Velocity>& velocity) const;
  void choose(const std::vector<Velocity>& velocity);
  bool bears(std::size_t point) const;
  void place_friction(std::vector<Velocity>& velocity);
  void choose_unknowns();
  std::size_t bandwidth();
  bool factor();
  void substitute();
  bool newton(std::vector<Velocity>& velocity);
  bool iterate(Real enough, std::vector<Velocity>& velocity);
  bool iterate_from_pivots(Real enough, std::vector<Velocity>& velocity);
  std::vector<double> rates_without_equations(const std::vector<Velocity>& velocity) const;
  bool pivot(std::vector<Velocity>& velocity);
  void sweep(std::vector<Velocity>& velocity);
  void keep(Real broken);
  void rebuild(std::vector<Velocity>& velocity);
  void go_back(std::vector<Velocity>& velocity) const;
  void slide_on_the_cone(Real enough, std::vector<Velocity>& velocity);
  void finish(Real enough, std::vector<Velocity>& velocity);

  std::vector<Constraint> rows_;
  bool begun_ = false;
  std::vector<std::pair<Velocity, Velocity>> start_;  // of the bodies of each row
  std::vector<Real> mass_;                            // kg or kg m^2, effective, of each row alone
  Real scale_ = 0;                                    // m/s, the largest term of a rate: what rounding is measured by
  std::vector<State> state_;                          // of each row
  std::vector<State> last_;                           // when the matrix was factored
  std::vector<std::uint32_t> free_;                   // rows whose impulses are solved for
  std::vector<std::uint32_t> slips_;                  // of each of these, the friction that follows it; or none
  std::vector<Real> slope_;                           // by how much
  std::vector<std::uint32_t> friction_of_;            // of each row, the friction that follows it; or none
  std::vector<std::uint32_t> first_of_;               // of each body, the first unknown that acts on it
  // The matrix has entries only in a band beside the diagonal; pivoting doubles the upper half of it.
  std::vector<Real> matrix_, right_;
  std::size_t band_ = 0, stride_ = 0, shift_ = 0;  // entry (i, j) is at i stride + j + shift
  std::vector<std::size_t> pivot_;
  bool factored_ = false;
  bool in_circles_ = false;  // Newton's method ended while what acts still changed
  Real least_broken_ = 0;    // m/s
  std::vector<Real> best_;   // impulses
};

}  // namespace impulse::inline IMPULSE_PRECISION
