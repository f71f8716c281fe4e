#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "contacts/contact_rows.h"
#include "contacts/normal_of.h"
#include "solver/island_joints.h"
#include "solver/motion.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The inverse of the matrix k of inverse effective masses of two points: maps velocity changes to impulses.
struct PairMatrix {
  Real i11 = 0, i22 = 0, i12 = 0;  // kg
  bool usable = false;  // false for points almost in one place: k does not determine the difference of their loads

  PairMatrix() = default;
  PairMatrix(Real k11, Real k22, Real k12) {
    const Real determinant = k11 * k22 - k12 * k12;
    constexpr Real worst_condition = 1000;
    usable = k11 * k22 <= worst_condition * determinant;
    if (!usable) return;
    const Real inverse = 1 / determinant;
    i11 = k22 * inverse;
    i22 = k11 * inverse;
    i12 = -k12 * inverse;
  }
  Vec2 operator*(Vec2 v) const { return {i11 * v.x + i12 * v.y, i12 * v.x + i22 * v.y}; }
};

/// Two points that are solved together.
struct PointPair {
  Real strength = 0;                   // of the soft constraint this was made for; 0: none
  std::array<Real, 2> inverse_mass{};  // 1/kg, effective, of each alone
  Real coupling = 0;                   // 1/kg, velocity change at one for an impulse at the other
  std::array<Real, 2> give{};          // 1/kg, compliance of the soft constraints
  PairMatrix rigid;
  PairMatrix soft;  // both points soft

  PairMatrix matrix(const std::array<Real, 2>& springs) const {
    return {inverse_mass[0] + springs[0], inverse_mass[1] + springs[1], coupling};
  }
};

/// A row with the additional data of the sub-step of `accurate`.
struct ImpactRow : ContactRow {
  Real offset = 0;           // m, lasting correction of the separation (see OffsetRule)
  Real disc_distance = 0;    // m, sum of radii when both are discs about their centres: their normal turns as they move
  Vec2 between;              // of those centres at the start of the step
  Vec2 led;                  // their normal before the sub-step's drift
  std::array<Vec2, 2> half;  // of each point's last impulse, along normal and tangent
  Vec2 acted;                // N s, impulse of the contact in this step, if its normal rotates
  int age = 0;               // steps since the contact began
  bool made = false;         // still valid if the contact's points are those below
  Pose found_a, found_b;
  std::array<Real, 2> found_separation{};
  NormalOf normal_of = NormalOf::between;  // set if it turns
  bool stirs_a = true;                     // the body can move, see BodySet::stirs
  bool stirs_b = true;
  bool turns = false;     // its normal follows the bodies within a step
  bool collides = false;  // a body that it stops is stopped at the time at which they meet
  bool active = true;     // takes part in this sub-step's solve
  bool fresh = false;     // first step of the contact
  bool slips = false;     // slides, so that the dynamic coefficient limits friction
  bool web = false;       // a body of it touches more than two others, as in a pyramid and not in a column
  bool block = false;     // its two points are solved together, by `pair`
  PointPair pair;

  bool two_frictions() const { return static_friction != dynamic_friction; }
  /// The coefficient that limits friction now.
  Real friction() const { return slips ? dynamic_friction : static_friction; }
  /// Adds a point's impulse, given along a normal and its tangent, to the totals of the step.
  void note(RowPoint& p, Vec2 impulse, Vec2 along) {
    p.total_normal += impulse.x;
    p.total_tangent += impulse.y;
    if (turns) acted += impulse.x * along + impulse.y * perpendicular(along);
  }
  /// Converts the totals along a rotating normal into impulses along one normal, which it returns.
  Vec2 join() {
    Vec2 given;
    for (const RowPoint& p : points) given += Vec2{p.total_normal, p.total_tangent};
    const Real sum = length(given);
    const Real effect = length(acted);
    if (sum == 0 || effect == 0) return normal;
    for (RowPoint& p : points) {
      p.total_normal *= effect / sum;
      p.total_tangent *= effect / sum;
    }
    return normalized(Rotation(given.x, given.y).inverse() * acted);
  }
};

/// m/s, a velocity that rounding may leave of none.
constexpr Real no_speed = static_cast<Real>(1e-4);

/// m/s, the restitution threshold: slower approaches are left to the contact solve, which ends the infinite sequence of
/// ever smaller bounces ("Zeno"). A body at rest under an acceleration a gains a h within a sub-step: with 1.2 to 5
/// times that, every stack of boxes settles. Without load, only rounding must be distinguished from an impact.
inline Real slow_impact(Real acceleration, Real h) { return static_cast<Real>(2.4) * acceleration * h + no_speed; }

/// Newton's impact law at the exact time of touching, inside a sub-step of h seconds.
///
/// Between impacts a body moves as d + v t + a t^2/2. At the earliest impact time tau the impulse J changes v by J/m;
/// shifting the start of the path by -tau J/m gives the same result as splitting the sub-step at tau. Repeats in order
/// of time until no contact with restitution hits before h. Rows that still approach afterwards hit in a later sub-step
/// and are inactive in this one.
///
/// Joints transmit an impact at once: the law is solved with the inverse masses of all that they connect, before the
/// paths are shifted.
class Impacts {
 public:
  /// Finds the contact of a row again where its bodies will be; returns whether its points may be others now.
  using FindAt = std::function<bool(const ImpactRow& row, const Motion& a, const Motion& b)>;

  /// `members` are the bodies that the rows and joints act on; `slow` is the approach (m/s) that is no impact yet.
  /// Returns the time of the last impact, 0 if there is none.
  Real resolve(std::span<ImpactRow> rows, IslandJoints& joints, std::span<const std::uint32_t> members, BodySet& bodies,
               std::vector<Motion>& motion, const std::vector<Velocity>& acceleration, Real h, Real slow,
               const FindAt& find_at);
  /// Contacts that were on their way to a later impact, but whose bodies the contact solve of others has turned towards
  /// each other: activates those that the drift of h seconds would make deeper by more than `most`, m. Returns whether
  /// there are any.
  bool hold_those_that_meet(std::span<ImpactRow> rows, const BodySet& bodies, const std::vector<Motion>& motion, Real h,
                            Real most, const FindAt& find_at) const;

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// A row with restitution.
  struct Candidate {
    std::uint32_t row = 0;
    std::uint32_t aims = 0;                            // number of searches for its next impact
    std::array<std::uint32_t, 2> next = {none, none};  // in the list of candidates of body a, of body b
  };
  struct Event {
    Real time = 0;   // of impact
    Real speed = 0;  // of approach then
    std::uint32_t candidate = 0;
    std::uint32_t aims = 0;  // the candidate's when this was found: outdated if it has more now
  };
  static bool later(const Event& left, const Event& right);
  void list_candidates(std::span<ImpactRow> rows, std::size_t body_count);
  void aim(std::span<const ImpactRow> rows, std::uint32_t candidate, const BodySet& bodies,
           const std::vector<Motion>& motion, const std::vector<Velocity>& acceleration, Real now, Real h);
  void strike(ImpactRow& row, IslandJoints& joints, std::span<const std::uint32_t> struck, BodySet& bodies,
              std::vector<Motion>& motion, const std::vector<Velocity>& acceleration, Real tau);
  void collide(ImpactRow& now, IslandJoints& joints, std::span<const std::uint32_t> struck, BodySet& bodies);

  Real slow_ = 0;
  std::vector<Candidate> candidates_;
  std::vector<std::uint32_t> first_of_;  // of each body's candidates; set only for bodies that have some
  std::vector<Event> events_;            // a heap
  std::vector<Velocity> before_;         // of the bodies that are hit
  std::vector<Velocity> joined_;         // the same, as their joints demand
};

}  // namespace impulse::inline IMPULSE_PRECISION
