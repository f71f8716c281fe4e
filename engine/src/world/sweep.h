#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "bodies/body_set.h"
#include "broad_phase/bounds_table.h"
#include "broad_phase/broad_phase.h"
#include "impulse/settings.h"
#include "joints/joint_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Continuous collision: a body that a step carried through something is put back to where it met it, and the next step
/// finds the contact. What is left of its step is lost. Solvers that look ahead know the points that will touch first;
/// what a corner's impact turns into the wall they need this for, too.
///
/// Looks only at what moved farther than half its thickness: the middles of two slower bodies cannot have passed each
/// other. What cut into another body without its middle meeting it is the solver's, so that a fast body may slide, roll
/// and graze at will.
class Sweep {
 public:
  Sweep();
  /// Before the step.
  void remember(const BodySet& bodies);
  /// After it.
  void hold_back(BodySet& bodies, const JointSet& joints, Continuous mode);

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  enum class Pace : std::uint8_t { slow, fast, bullet };
  /// Where a body's step ends.
  struct Stop {
    Real after = 1;             // share of the step
    bool turns_on = false;      // only the way is cut short
    std::uint32_t with = none;  // what it met there, if that is immovable: it carries the body through the rest
  };
  struct Immovable {
    Aabb bounds;  // of all its way through the step
    const Shape* shape;
    Pose start;
    Real way;  // m, no point of it goes farther
  };
  struct Path;
  struct Mover;

  Path path(const BodySet& bodies, std::size_t i) const;
  bool find_fast(const BodySet& bodies, Continuous mode);
  void list_concerned(const BodySet& bodies);
  void find_immovable(const BodySet& bodies);
  bool may_meet_immovable(const BodySet& bodies, std::size_t i);
  void find_pairs(const BodySet& bodies);
  void stop_at_immovable(const BodySet& bodies, const JointSet& joints);
  void stop_at_each_other(const BodySet& bodies, const JointSet& joints);
  Stop meeting_of(const BodySet& bodies, const Proxy& met, const Proxy& moving) const;
  void put_back(BodySet& bodies, std::size_t i) const;

  std::vector<Pose> start_;
  std::vector<Real> start_angle_;
  std::vector<Pace> pace_;
  std::vector<std::uint32_t> concerned_;  // bodies that may stop or be met, in order
  bool meets_movable_ = false;            // something fast stops at movable bodies, or stops them
  std::vector<Stop> stops_;
  std::vector<Immovable> immovable_;  // all parts that don't give way
  BoundsTable immovable_bounds_;
  std::vector<Proxy> proxies_;
  std::vector<Pair> pairs_;
  std::unique_ptr<BroadPhase> broad_phase_;  // its own: the world's keeps what it learnt about the world's proxies
};

}  // namespace impulse::inline IMPULSE_PRECISION
