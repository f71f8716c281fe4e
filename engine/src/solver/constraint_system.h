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
  double bias = 0;     // m/s or rad/s
  double impulse = 0;  // N s or N m s: a guess, and the solution
  double given = 0;    // of these, what the velocities contain before they are solved for
  double most = 0;     // of a motor
  bool fixed = false;  // its impulse is not to change
  Real place = 0;      // where it acts, by any measure: neighbours are eliminated one after the other

  // Of friction: its points, at most two, which stand before it in a row, and where it acts on each.
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  Real friction = 0;  // coefficient
  std::array<Real, 2> point_a{}, point_b{};
  std::array<double, 2> point_bias{};
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
///
/// Computes in double whatever the engine's precision: what rounds are the rows that it is given, which may contradict
/// each other by that, and the velocities that it leaves.
class ConstraintSystem {
 public:
  void clear();
  std::uint32_t add(const Constraint& constraint);
  std::span<Constraint> all() { return rows_; }
  std::span<const Constraint> all() const { return rows_; }
  /// Whether laws contradicted each other in one of the solutions since clear().
  bool yielded() const { return yielded_; }
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
  /// The coefficient of a row that rubs, between two calls.
  void set_friction(std::uint32_t row, Real coefficient) {
    factored_ = factored_ && rows_[row].friction == coefficient;
    rows_[row].friction = coefficient;
  }
  /// Velocities as before the first call, from which the next one starts with the solution as a guess.
  void restart(std::vector<Velocity>& velocity);

  /// m/s or rad/s, without bias.
  static double speed(const Constraint& row, const std::vector<Velocity>& velocity) {
    return speed(row, Precise(velocity[row.a]), Precise(velocity[row.b]));
  }
  /// The same of a row, before the first call.
  double speed_at_start(std::size_t i) const { return speed(rows_[i], start_[ends_[i].a], start_[ends_[i].b]); }
  /// J, that the impulses did.
  struct Work {
    double done = 0, rounding = 0;

    bool is_none() const { return done <= rounding; }
  };
  Work work() const;

 private:
  static constexpr std::uint32_t no_number = ~std::uint32_t{0};
  /// A fraction of a constraint's own inverse mass, by which it yields while it is solved for: that decides between
  /// equal ways to share a load. It does not stay: what it leaves is solved in the next round. More than rows
  /// contradict each other by.
  static constexpr double least_compliance = sizeof(Real) == 8 ? 1e-9 : 1e-4;
  /// The same of equations, few of which share a load: beams of many links are far stiffer than each of these.
  static constexpr double least_of_equations = sizeof(Real) == 8 ? 1e-9 : 1e-6;
  /// The same of what else bears where there are equations, which let bodies move in few ways: the rounding of a gap,
  /// or what is not linear in an interval, may contradict them.
  static constexpr double least_of_joined = sizeof(Real) == 8 ? 1e-6 : 1e-4;
  /// Where a round brings laws no nearer than by `slowly`, as of a light body under one 1e4 times as heavy, the next
  /// ones have `firmer` times as much of it, `firmest` at least. Rows that contradict each other are nearer than
  /// that from the first round on; where there are equations, nearer than `most_yield` of the fastest motion.
  static constexpr double slowly = 1. / 8, firmer = 1. / 64, firmest = 1e-9;
  /// Where a round breaks laws by so many times as much as they were broken before, what holds contradicts each other.
  static constexpr double wild = 1e3;

  /// The same where laws contradict each other, and it stays: a body held by two that nothing pushes bears a thousand
  /// times what would stop it. They do where they are broken by more than this of the fastest motion.
  static constexpr double most_yield = 1e-3;
  /// Times the fastest of the motions and gaps to be mended at the start: what a yielding wedge can give, whose angle
  /// is the root of most_yield, v / (2 sqrt(most_yield)).
  static constexpr double most_leverage = 16;

  /// A velocity while it is solved for.
  struct Precise {
    double x = 0, y = 0;  // m/s
    double w = 0;         // rad/s

    Precise() = default;
    explicit Precise(const Velocity& from) : x(double{from.v.x}), y(double{from.v.y}), w(double{from.w}) {}
  };
  static double speed(const Constraint& row, const Precise& a, const Precise& b) {
    return double{row.axis.x} * (b.x - a.x) + double{row.axis.y} * (b.y - a.y) + b.w * double{row.arm_b} -
           a.w * double{row.arm_a};
  }
  /// The bodies of a row, by their number in the system.
  struct Ends {
    std::uint32_t a = 0, b = 0;
  };

  enum class State : std::uint8_t { off, holds, forward, backward };

  /// The change of the rate of p for a unit impulse along q, through the bodies that both act on.
  static double response(const Constraint& p, const Constraint& q) {
    const auto through = [&](const InverseMass& mass, Real arm_p, Real arm_q) {
      const double along = double{p.axis.x} * double{q.axis.x} + double{p.axis.y} * double{q.axis.y};
      return double{mass.m} * along + double{mass.i} * double{arm_p} * double{arm_q};
    };
    double sum = 0;
    if (p.a == q.a) sum += through(p.mass_a, p.arm_a, q.arm_a);
    if (p.b == q.b) sum += through(p.mass_b, p.arm_b, q.arm_b);
    if (p.a == q.b) sum -= through(p.mass_a, p.arm_a, q.arm_b);
    if (p.b == q.a) sum -= through(p.mass_b, p.arm_b, q.arm_a);
    return sum;
  }
  std::uint32_t number_of(std::uint32_t body);
  State guessed_state(const Constraint& row, double rounding) const;
  void begin(const std::vector<Velocity>& velocity);
  void tell(std::vector<Velocity>& velocity) const;
  void weigh(std::size_t i);
  double rate(std::size_t i) const;
  void change(std::size_t i, double by);
  void give(std::size_t i, double by);
  double load(const Constraint& friction) const;
  double wanted(std::size_t i, double rate) const;
  double broken_by();
  void choose();
  bool bears(std::size_t point) const;
  void place_friction();
  void choose_unknowns();
  void list_by_body();
  bool factor();
  void substitute();
  bool newton();
  bool shoots() const;
  bool iterate(double enough);
  bool iterate_from_pivots(double enough);
  std::vector<double> rates_without_equations() const;
  bool pivot();
  void note_impulses();
  bool back_to_first_bound();
  void sweep();
  void keep(double broken);
  void rebuild();
  void slide_on_the_cone(double enough);
  void yield(double enough);
  void finish(double enough);
  double enough() const;
  double sums_round_off() const;
  double contradiction() const;
  void be_firm(double share);

  std::vector<Constraint> rows_;
  std::vector<Ends> ends_;                // of each row
  std::vector<std::uint32_t> bodies_;     // by their number in the system
  std::vector<std::uint32_t> number_of_;  // of each body, its number or none
  bool begun_ = false;
  std::vector<Precise> start_;  // of each body of the system, before the first call
  std::vector<Precise> now_;
  std::vector<double> mass_;                // kg or kg m^2, effective, of each row alone
  double scale_ = 0;                        // m/s, the largest term of a rate without impulses, by which rows round
  double pushed_ = 0;                       // m/s, the largest change of a rate by its own impulse
  double fastest_ = 0;                      // m/s, the largest of these but for impulses, before the first call
  double yield_ = 0;                        // of a row's own inverse mass, while all laws yield
  double firm_ = 1;                         // share of the compliance that is left
  std::vector<State> state_;                // of each row
  std::vector<State> last_;                 // when the matrix was factored
  std::vector<std::uint32_t> free_;         // rows whose impulses are solved for
  std::vector<std::uint32_t> slips_;        // of each of these, the friction that follows it; or none
  std::vector<double> slope_;               // by how much
  std::vector<std::uint32_t> friction_of_;  // of each row, the friction that follows it; or none
  // The unknowns that act on each body of the system, one body's after the other's, and where those of each begin.
  std::vector<std::uint32_t> on_body_, first_on_, next_on_;
  std::vector<std::uint32_t> last_in_;  // of each row of the matrix, the last entry that may not be 0
  // The matrix has entries only in a band beside the diagonal; pivoting doubles the upper half of it.
  std::vector<double> matrix_, right_;
  std::size_t band_ = 0, stride_ = 0, shift_ = 0;  // entry (i, j) is at i stride + j + shift
  std::vector<std::size_t> pivot_;
  bool factored_ = false;
  bool joined_ = false;                // some row is an equation
  bool yielded_ = false;               // since clear()
  bool in_circles_ = false;            // Newton's method ended while what acts still changed
  std::vector<double> rates_;          // m/s or rad/s, of each row, when broken_by() was last asked
  double least_broken_ = 0;            // m/s
  std::vector<double> best_;           // impulses
  std::vector<double> last_impulses_;  // before the last step
};

}  // namespace impulse::inline IMPULSE_PRECISION
