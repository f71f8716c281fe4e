#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "bodies/body_set.h"
#include "broad_phase/bounds_table.h"
#include "broad_phase/broad_phase.h"
#include "contacts/contact_set.h"
#include "impulse/settings.h"
#include "joints/joint_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Continuous collision: moves a body that a step carried through something back to where they met, and leaves the
/// contact to the next step. The body loses the rest of its step. Solvers that look ahead see the points that touch
/// first; they too need this when an impact at one corner rotates another into the wall.
///
/// Considers only bodies that moved farther than half their thickness: the core circles of two slower bodies cannot
/// have passed each other. If a shape cuts into another while its core circle stays outside, the overlap is left to the
/// solver, so that fast bodies can slide, roll and graze freely.
class ContinuousCollision {
 public:
  ContinuousCollision();
  /// Call before the step: stores the poses.
  void store_start(const BodySet& bodies);
  /// What passes through each other: joined bodies, parts that the filter refuses, and disabled contacts.
  struct Passing {
    const JointSet& joints;
    const PartFilter& filter;
    const ContactSet& contacts;
  };
  /// Call after the step: clamps the motion of fast bodies to their times of impact.
  void clamp_to_impacts(BodySet& bodies, const Passing& passing, Continuous mode);

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  enum class MotionClass : std::uint8_t { slow, fast, bullet };
  /// Where the motion of a body ends.
  struct Stop {
    Real time = 1;               // of impact, as a share of the step
    bool keeps_turning = false;  // whether only the translation ends
    std::uint32_t with = none;   // the body it met, if that is not dynamic: it carries this one through the rest
  };
  /// A part of a fixed or kinematic body.
  struct Immovable {
    Aabb bounds;  // of its path through the step
    const Shape* shape;
    Pose start;
    Real displacement;  // m, upper bound for all of its points
  };
  struct Path;
  struct MovingShape;

  Path path(const BodySet& bodies, std::size_t i) const;
  bool classify_motion(const BodySet& bodies, Continuous mode);
  void list_candidates(const BodySet& bodies);
  void list_immovable(const BodySet& bodies);
  bool may_meet_immovable(const BodySet& bodies, std::size_t i);
  void find_pairs(const BodySet& bodies, const Passing& passing);
  void stop_at_immovable(const BodySet& bodies);
  void stop_at_each_other(const BodySet& bodies);
  Stop find_stop(const BodySet& bodies, const Proxy& obstacle, const Proxy& moving) const;
  void clamp_body(BodySet& bodies, std::size_t i) const;

  std::vector<Pose> start_;
  std::vector<Real> start_angle_;
  std::vector<MotionClass> motion_class_;
  std::vector<std::uint32_t> candidates_;  // bodies that may stop or be hit, sorted
  bool hits_dynamic_ = false;              // whether something fast stops at dynamic bodies or stops them
  std::vector<Stop> stops_;
  std::vector<Immovable> immovable_;
  BoundsTable immovable_bounds_;
  std::vector<Proxy> proxies_;
  std::vector<Pair> pairs_;
  std::unique_ptr<BroadPhase> broad_phase_;  // its own, because that of the world keeps state about the world's proxies
};

}  // namespace impulse::inline IMPULSE_PRECISION
