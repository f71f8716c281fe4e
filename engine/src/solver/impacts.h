#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "solver/impact_row.h"
#include "solver/island_joints.h"
#include "solver/motion.h"

namespace impulse::inline IMPULSE_PRECISION {

/// m/s, the restitution threshold: slower approaches are left to the contact solve, which ends the infinite sequence of
/// ever smaller bounces ("Zeno"). A body at rest under an acceleration a gains a h within a sub-step: with 1.2 to 5
/// times that, every stack of boxes settles. Without load, only rounding must be distinguished from an impact.
inline Real slow_impact(Real acceleration, Real h) { return static_cast<Real>(2.4) * acceleration * h + no_speed; }

/// m/s, the sliding that breaks a contact of a web away which bears all of its static friction: in a web masses do not
/// say how contacts share a load, so the sweeps may ask more of one than another could bear. One that cannot be held
/// gains (F - mu_s N) h / m in a sub-step: more than this in the first one if a tenth of the load is missing.
inline Real no_slip_in_web(Real acceleration, Real h) { return static_cast<Real>(0.1) * acceleration * h + no_slip; }

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
  void resolve(std::span<ImpactRow> rows, IslandJoints& joints, std::span<const std::uint32_t> members, BodySet& bodies,
               std::vector<Motion>& motion, const std::vector<Velocity>& acceleration, Real h, Real slow,
               const FindAt& find_at);
  /// Contacts that were on their way to a later impact or left out because they are far, but whose bodies the contact
  /// solve of others has turned towards each other: activates those that the drift of h seconds would make deeper by
  /// more than `most`, m. Returns whether there are any.
  bool hold_those_that_meet(std::span<ImpactRow> rows, const BodySet& bodies, const std::vector<Motion>& motion, Real h,
                            Real most, const FindAt& find_at);
  /// Sets at what speed points part, for paths that impacts have shifted, until forget_paths().
  void note_paths(std::span<ImpactRow> rows, const std::vector<Motion>& motion, Real h) const;
  static void forget_paths(std::span<ImpactRow> rows);

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// A row with restitution.
  struct Candidate {
    std::uint32_t row = 0;
    std::uint32_t aims = 0;                            // number of searches for its next impact
    bool struck = false;                               // in this sub-step
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
  bool struck_ = false;  // anything in this sub-step
  FlownMotions flown_;
  std::vector<Candidate> candidates_;
  std::vector<std::uint32_t> first_of_;  // of each body's candidates; set only for bodies that have some
  std::vector<Event> events_;            // a heap
  std::vector<Velocity> before_;         // of the bodies that are hit
  std::vector<Motion> began_;            // of each body, at the start of the sub-step, where its path did
  std::vector<Velocity> joined_;         // the same, as their joints demand
};

}  // namespace impulse::inline IMPULSE_PRECISION
