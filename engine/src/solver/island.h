#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "impulse/settings.h"
#include "solver/impacts.h"
#include "solver/island_joints.h"
#include "solver/partition.h"
#include "solver/softness.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// How the standing offset o of a contact follows the depth x that its load presses in, from step to step:
///
///   o += gain x - leak o
class OffsetRule {
 public:
  /// steps; the first ones of a contact are no standing load yet.
  static constexpr int from_age = 2;

  OffsetRule() = default;

  /// Lifts what has sunk altogether, with o' = r x: r is 2/s, or less where that would pump the pile's slowest wave. L
  /// layers on springs of frequency w and damping ratio z swing with W = w pi / (2 L), damped by c = 2 z w (pi / (2
  /// L))^2; with the offset o as part of the spring, x'' + c x' + W^2 (x + o) = g and o' = r x, which is stable for r <
  /// c. A pyramid of 100 rows, c = .6/s, shakes without end at r = 1/s and for 20 s at .5; r = c / 4 costs it a quarter
  /// of its damping.
  static OffsetRule lifting(Real dt, Real layers, Real damping_ratio, const Softness& soft) {
    const Real wave = pi / (2 * layers);
    const Real damping = 2 * damping_ratio * soft.omega * wave * wave;
    constexpr Real soonest = 2;  // 1/s; 1 ... 4 are all stable in stacks of ten, 2 settles soonest
    OffsetRule rule;
    rule.gain_ = dt * std::min(soonest, damping / 4);
    return rule;
  }

  /// Lifts up to two thirds of what has sunk, and never gives energy to anything. For heaps: what rolls and slides
  /// there has slow modes that no spring damps, and to these an offset that lifts without an end is a motor. A spring k
  /// with the damper k q, q = 2 z / w, and o' = r x - l o answers a depth that swings with W by the stiffness
  ///
  ///   k (1 + r / (i W + l)) + i W k q
  ///
  /// and takes energy where its imaginary part is positive: q > r / (W^2 + l^2). Without the leak l this fails below
  /// W = sqrt(r / q), whatever r: 2000 smooth discs in a box moved at .04 m/s for as long as one looked, 1000 discs and
  /// 1000 boxes with friction at .01 m/s after 15 s (and at .0001 with this rule). With r / l^2 < q it never fails. In
  /// steps of dt, o += gain x - leak o is as late as its depths are old on the mean, (1 - leak) / leak steps, and half
  /// a step because it then stays for one: (gain / leak) ((1 - leak) / leak + 1 / 2) dt < q. Three quarters of that are
  /// taken at most; and gain + leak <= 1, lest the offset overshoot.
  static OffsetRule passive(Real dt, Real damping_ratio) {
    OffsetRule rule;
    rule.leak_ = Real{1} / 3;
    constexpr Real taken = Real{3} / 4;
    const Real late = dt * ((1 - rule.leak_) / rule.leak_ + Real{1} / 2);
    rule.gain_by_omega_ = rule.leak_ * taken * 2 * damping_ratio / late;
    return rule;
  }

  /// Of a contact so soft.
  Real gain(const Softness& soft) const {
    if (leak_ == 0) return gain_;
    return std::min(gain_by_omega_ / soft.omega, 1 - leak_);
  }
  Real leak() const { return leak_; }

 private:
  Real gain_ = 0;  // where nothing leaks
  Real leak_ = 0;
  Real gain_by_omega_ = 0;  // rad/s
};

/// A sub-step is so short that an island would sink by this much (m) at most before the standing offset lifts it.
constexpr Real tolerated_sink = static_cast<Real>(0.0005);

/// One island of `accurate` for the length of a step.
struct Island {
  std::span<const std::uint32_t> bodies;
  std::span<const Tie> contacts;
  std::span<ImpactRow> rows;  // of the contacts, unless they are solved as a pile (pile.h)
  IslandJoints joints;
  int substeps = 1;
  int sweeps = 1;        // joints and contacts, or joints and their stops, are solved in turn
  int press_sweeps = 0;  // that may be added until a blow presses nothing in
  int more_sweeps = 0;   // that relaxation may take until it gains no energy
  Real h = 0;
  struct Softnesses {
    Softness movable, fixed;  // between movable bodies; against what cannot move
  };
  Softnesses column;
  Softnesses web;  // only of islands that are webbed
  OffsetRule offsets;
  Real offset_scale =
      1;                // of contacts' offsets: depths under a load go with h^2, and what is kept is of the settings' h
  bool webbed = false;  // some contact is in a web, see Partition::in_web
  bool heap = false;    // see is_heap()
  bool held = false;    // something that cannot be pushed holds it; not asked of a pile
  bool ideal = false;   // its joints are all that could add energy, and they must not
  bool bounces = false;   // some contact has restitution
  bool struck = false;    // closes at speed, which may set any body turning
  bool turning = false;   // normals and arms follow its bodies within a step, see turning.h
  bool settling = false;  // begins at rest: its loads are found at once

  const Softness& softness(bool in_web, const InverseMass& a, const InverseMass& b) const {
    const Softnesses& of = in_web ? web : column;
    return a.m == 0 || b.m == 0 ? of.fixed : of.movable;
  }
  const Softness& softness(const ImpactRow& row) const { return softness(row.web, row.mass_a, row.mass_b); }

  /// w h of a contact.
  static constexpr Real swing(bool in_web, bool fixed) { return 2 * pi / Real(in_web ? 12 : 8) * Real(fixed ? 2 : 1); }

  /// Sets h and the softness that goes with it: the highest frequency that does not jitter, 1/(8 h) in a column, and
  /// twice that against what cannot move. In the web of a pyramid, where each body pushes several that push back within
  /// the same sweep, it is 1/(12 h): at 1/(8 h) one of base 20 shakes itself up to .08 m/s and is not still after 25 s,
  /// at 1/(10 h) after 6.6 s, at 1/(12 h) after 3.3 s. A load then rests at a depth of load / (2 m_eff w^2), half of
  /// the usual, because half of each sub-step's impulse is already given when the contact is solved.
  void cut(const Settings& settings, int into);
  /// Impulses of a whole step to those of one of n sub-steps, and back.
  void share(Real by);
};

/// Whether nothing outside does work on an island but the forces: all its bodies can be pushed.
bool closed(const BodySet& bodies, std::span<const std::uint32_t> island);
/// Whether an island is a heap, in which slow motions find no end by themselves: a web in which faces seldom lie on
/// faces, as they do in walls and pyramids, that is so large that its contacts give way (it has no more sub-steps than
/// the settings', see substeps_for), or not of few bodies and without friction that would lock it.
bool is_heap(const StepData& data, const Island& island);
/// Whether an island begins at rest: nothing touched before, and all are slow.
bool settles(const StepData& data, const Island& island);

/// What carries an island's weight.
struct Bearing {
  int points = 0;                                         // on what cannot move
  Real lightest = std::numeric_limits<Real>::infinity();  // kg, effective, of a point
  Real deepest = 0;  // m, that a load of the last step presses in beyond the offset, in sub-steps of the settings

  void add(const ContactRow& row);
  void add_load(const ImpactRow& row, Real offset, const Settings& settings);
};

/// How many sub-steps an island needs so that its own weight presses it no deeper than tolerated, at most 32 and the
/// settings' number at least. From masses alone: an estimate from the impulses would flicker with them, and a stack
/// would topple while it is low.
int substeps_for(std::span<const std::uint32_t> island, const Bearing& bearing, const BodySet& bodies,
                 const std::vector<Velocity>& acceleration, const Settings& settings);
/// Whether substeps_for may exceed the settings' number for an island of so many bodies.
bool may_need_substeps(std::size_t bodies, const Settings& settings);

/// An island that begins at rest finds its loads in so many sweeps of each sub-step instead of sinking until it has
/// them.
int settling_sweeps_for(std::size_t bodies);

/// How often an island of so many bodies that was struck may be relaxed beyond its sweeps: not where it would be dear.
int more_sweeps_for(std::size_t bodies);

/// So few bodies that a blow may go all the way through.
bool few(const Island& island);
/// Whether a sub-step of it is one pass over its contacts and nothing else.
bool plain(const Island& island);

/// New, or deeper than loads press in but in the largest piles.
bool new_or_deep(const Contact& contact);
/// Whether the points move along the normal as only a blow makes them.
bool at_speed(const ContactRow& row, const BodySet& bodies);
/// Whether a contact closes at speed within a step of dt.
bool closes(const ContactRow& row, const BodySet& bodies, Real dt);

/// What was pressed within a sub-step, but is pushed by nothing in the end, flies on without the rounding of what it
/// was given and gave back: no contact would explain it.
class Unpushed {
 public:
  /// Remembers how the island's bodies come out of a sub-step by the force field alone.
  void note(const Island& island, const BodySet& bodies, const std::vector<Velocity>& acceleration);
  /// Gives that to those that carry no load, by the marks of all bodies.
  void restore(const Island& island, const std::vector<std::uint8_t>& loaded, BodySet& bodies) const;

 private:
  std::vector<Velocity> flown_;  // of the island's bodies
};

}  // namespace impulse::inline IMPULSE_PRECISION
