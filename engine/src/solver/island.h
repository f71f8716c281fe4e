#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "core/softness.h"
#include "impulse/settings.h"
#include "solver/impacts.h"
#include "solver/island_joints.h"
#include "solver/partition.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The integral bias of a contact: how its offset o follows the penetration x under its load, from step to step,
///
///   o += gain x - leak o
class OffsetRule {
 public:
  /// steps; in the first steps of a contact its load is not steady yet.
  static constexpr int from_age = 2;

  OffsetRule() = default;

  /// Removes penetration completely, with o' = r x: r is 2/s, or less if that would excite the pile's slowest wave. L
  /// layers on springs of frequency w and damping ratio z oscillate at W = w pi / (2 L), damped by c = 2 z w (pi / (2
  /// L))^2; with the offset o as part of the spring, x'' + c x' + W^2 (x + o) = g and o' = r x, which is stable for
  /// r < c. A pyramid of 100 rows, c = .6/s, oscillates forever at r = 1/s and for 20 s at .5; r = c / 4 costs a
  /// quarter of its damping.
  static OffsetRule lifting(Real dt, Real layers, Real damping_ratio, const Softness& soft) {
    const Real wave = pi / (2 * layers);
    const Real damping = 2 * damping_ratio * soft.omega * wave * wave;
    constexpr Real soonest = 2;  // 1/s; 1 ... 4 are all stable in stacks of ten, 2 settles soonest
    OffsetRule rule;
    rule.gain_ = dt * std::min(soonest, damping / 4);
    return rule;
  }

  /// A leaky integrator: removes up to two thirds of the penetration and never adds energy. For granular piles: rolling
  /// and sliding there have slow modes that no spring damps, and for these an integrator without a leak is a motor. A
  /// spring k with the damper k q, q = 2 z / w, and o' = r x - l o responds to a depth that oscillates at W with the
  /// stiffness
  ///
  ///   k (1 + r / (i W + l)) + i W k q
  ///
  /// and dissipates energy if its imaginary part is positive: q > r / (W^2 + l^2). Without the leak l this fails below
  /// W = sqrt(r / q) for every r: 2000 frictionless discs in a box kept moving at .04 m/s, 1000 discs and 1000 boxes
  /// with friction at .01 m/s after 15 s (and at .0001 with this rule). With r / l^2 < q it never fails. In steps of
  /// dt, o += gain x - leak o lags by the mean age of its depths, (1 - leak) / leak steps, and half a step because it
  /// is constant within one: (gain / leak) ((1 - leak) / leak + 1 / 2) dt < q. At most three quarters of that are used;
  /// and gain + leak <= 1, so that the offset does not overshoot.
  static OffsetRule passive(Real dt, Real damping_ratio) {
    OffsetRule rule;
    rule.leak_ = Real{1} / 3;
    constexpr Real taken = Real{3} / 4;
    const Real late = dt * ((1 - rule.leak_) / rule.leak_ + Real{1} / 2);
    rule.gain_by_omega_ = rule.leak_ * taken * 2 * damping_ratio / late;
    return rule;
  }

  /// The gain for a contact of this softness.
  Real gain(const Softness& soft) const {
    if (leak_ == 0) return gain_;
    return std::min(gain_by_omega_ / soft.omega, 1 - leak_);
  }
  Real leak() const { return leak_; }

 private:
  Real gain_ = 0;  // without a leak
  Real leak_ = 0;
  Real gain_by_omega_ = 0;  // rad/s
};

/// m; sub-steps are short enough that an island would penetrate by at most this before its offsets take up the load.
constexpr Real tolerated_sink = static_cast<Real>(0.0005);

/// One island of `accurate` during a step.
struct Island {
  std::span<const std::uint32_t> bodies;
  std::span<const Tie> contacts;
  std::span<ImpactRow> rows;              // of the contacts, unless they are solved as a pile (pile.h)
  std::span<const std::uint32_t> acting;  // indices of the rows that take part in this sub-step's solve, in order
  IslandJoints joints;
  std::span<const Pull> pulls = {};
  bool varies = false;  // forces vary within the step
  int substeps = 1;
  int least_substeps = 0;  // after fewer have not sufficed
  int sweeps = 1;          // iterations over joints and contacts, or joints and their stops
  int press_sweeps = 0;    // extra rigid iterations allowed until an impact adds no penetration
  int more_sweeps = 0;     // extra iterations of relax allowed until the energy bound holds
  int unsolved = 0;        // sub-steps in which those of a blow did not suffice
  bool jammed = false;     // some bodies overlap deeply: each time that sweeps have not sufficed there are half as many
  Real h = 0;
  struct Softnesses {
    Softness movable, fixed;  // between movable bodies; with one that cannot move
  };
  Softnesses column;
  Softnesses web;  // set only if `webbed`
  OffsetRule offsets;
  Real offset_scale =
      1;                // of contacts' offsets: depths under a load go with h^2, and what is kept is of the settings' h
  bool webbed = false;  // some contact is in a web, see Partition::in_web
  bool heap = false;    // see is_heap()
  bool pile = false;    // see is_pile()
  bool held = false;    // a body that cannot be pushed holds it; not set for a pile
  bool ideal = false;   // only its joints could add energy, and they must not
  bool bounces = false;        // some contact has restitution
  bool two_frictions = false;  // of some contact
  Real pressing = 0;           // m/s^2, the largest acceleration of a body by forces; set if contacts ask for it
  bool struck = false;         // an impact that may set any body rotating
  bool turning = false;        // normals and arms follow the bodies within a step, see turning.h
  bool settling = false;       // starts at rest: solve its initial load at once

  const Softness& softness(bool in_web, const InverseMass& a, const InverseMass& b) const {
    const Softnesses& of = in_web ? web : column;
    return a.m == 0 || b.m == 0 ? of.fixed : of.movable;
  }
  const Softness& softness(const ImpactRow& row) const { return softness(row.web, row.mass_a, row.mass_b); }

  /// w h of a contact.
  static constexpr Real swing(bool in_web, bool fixed) { return 2 * pi / Real(in_web ? 12 : 8) * Real(fixed ? 2 : 1); }

  /// Divides the step into `into` sub-steps and sets the softness for them: the highest frequency that does not jitter,
  /// 1/(8 h) in a column, and twice that for a contact with a body that cannot move. In the web of a pyramid, where
  /// each body pushes several that push back within the same iteration, it is 1/(12 h): at 1/(8 h) one of base 20
  /// oscillates up to .08 m/s and has not settled after 25 s, at 1/(10 h) after 6.6 s, at 1/(12 h) after 3.3 s. A load
  /// then rests at a depth of load / (2 m_eff w^2), half of the usual, because half of each sub-step's impulse is
  /// already applied when the contact is solved.
  void cut(const Settings& settings, int into);
  /// Scales impulses between a whole step and a sub-step.
  void share(Real by);
};

/// Whether only forces do work on an island from outside: all its bodies can be pushed.
bool closed(const BodySet& bodies, std::span<const std::uint32_t> island);
/// Whether an island is a granular pile, in which slow motions do not stop by themselves: a web in which faces seldom
/// lie on faces, unlike in walls and pyramids, and that is either so large that its contacts are compliant (it has only
/// the sub-steps of the settings, see substeps_for), or not small and without friction that would lock it.
bool is_heap(const StepData& data, const Island& island);
/// Whether an island starts at rest, in whatever frame: all its contacts are new, and their bodies hardly move relative
/// to each other.
bool settles(const StepData& data, const Island& island);

/// The support estimate of an island.
struct Bearing {
  int points = 0;                                         // with bodies that cannot move
  Real lightest = std::numeric_limits<Real>::infinity();  // kg, effective, of a point
  Real deepest =
      0;  // m, penetration beyond the offset under a load of the last step, with the sub-steps of the settings

  void add(const ContactRow& row);
  void add_load(const ContactRow& row, bool in_web, Real offset, const Settings& settings);
};

/// The number of sub-steps an island needs so that its weight causes no more than the tolerated penetration: at least
/// the settings' number and at most 32. Computed mainly from masses: an estimate from impulses alone would fluctuate
/// with them, and a stack would topple while it is low.
int substeps_for(const Island& island, const Bearing& bearing, const BodySet& bodies,
                 const std::vector<Velocity>& acceleration, const Settings& settings);
/// The number of sub-steps in which bodies go no farther than an eighth of their distance while they pass what attracts
/// them (see ForceField::passing_rate): at least the settings' number and at most 64.
int substeps_past(const StepData& data, std::span<const std::uint32_t> island);
/// Whether an island of this many bodies may be stepped again with twice as many sub-steps.
bool may_halve(std::size_t bodies, int substeps);
/// Whether an island of this many bodies is too large to be swept a second time, or to be cut anew beside a part at
/// rest.
bool is_large(std::size_t bodies, const Settings& settings);
/// Whether substeps_for may exceed the settings' number for a pile of this many bodies.
bool may_need_substeps(std::size_t bodies, const Settings& settings);

/// The iterations of each sub-step in which an island that starts at rest finds its loads, instead of penetrating until
/// it has them.
int settling_sweeps_for(std::size_t bodies);

/// The extra iterations of relax after an impact for an island of this many bodies; 0 if that would be expensive.
int more_sweeps_for(std::size_t bodies);

/// The extra rigid iterations of a blow: those that pass it through the whole island, or as many as the budget allows.
int press_sweeps_for(std::size_t bodies);

/// Small enough that an impact may be solved through the whole island.
bool few(const Island& island);

/// New, or deeper than under loads at rest, except in the largest piles.
bool new_or_deep(const Contact& contact);
/// Whether the points move along the normal faster than without an impact.
bool at_speed(const ContactRow& row, const BodySet& bodies);
/// Whether a contact closes within a step of dt faster than without an impact.
bool closes(const ContactRow& row, const BodySet& bodies, const std::vector<Velocity>& acceleration, Real dt);

/// Ballistic restore: a body that got impulses within a sub-step but carries no load at its end continues as in free
/// flight, without the rounding of impulses applied and taken back, which no contact would report.
class Unpushed {
 public:
  /// Records the velocities of the island's bodies after a sub-step under the force field alone.
  void note(const Island& island, const BodySet& bodies, const std::vector<Velocity>& acceleration);
  /// Sets those velocities for bodies that carry no load; `loaded` has a flag for each body.
  void restore(const Island& island, const std::vector<std::uint8_t>& loaded, BodySet& bodies) const;

 private:
  std::vector<Velocity> flown_;  // of the island's bodies
};

}  // namespace impulse::inline IMPULSE_PRECISION
