#include "reports/find/admissible.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

#include "reports/judge/contacts.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/overlap.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

// m/s, at which the joint's constraint is broken at the start.
double speed_apart(const Joint& joint, std::span<const BodyState> start) {
  return std::visit(
      [&](const auto& one) {
        using Tie = std::decay_t<decltype(one)>;
        const BodyState& a = start[one.a];
        const BodyState& b = start[one.b];
        if constexpr (std::is_same_v<Tie, Distance>) {
          const Vec line = one.anchor_b - one.anchor_a;
          const double span = length(line);
          if (one.stiffness > 0 || span == 0) return 0.0;
          return std::abs(dot(line, velocity_at(b, one.anchor_b) - velocity_at(a, one.anchor_a))) / span;
        } else {
          const Vec apart = velocity_at(b, one.anchor) - velocity_at(a, one.anchor);
          const double turning = std::abs(b.angular_velocity - a.angular_velocity);
          if constexpr (std::is_same_v<Tie, Revolute>) return length(apart);
          if constexpr (std::is_same_v<Tie, Weld>) return length(apart) + turning;
          if constexpr (std::is_same_v<Tie, Prismatic>) return std::abs(cross(one.axis, apart)) + turning;
        }
      },
      joint);
}

double gap_of(const Joint& joint) {
  const auto* rod = std::get_if<Distance>(&joint);
  return rod == nullptr || rod->stiffness > 0 ? 0 : std::abs(length(rod->anchor_b - rod->anchor_a) - rod->length);
}

}  // namespace

Contradictions contradictions(const Scene& scene) {
  const auto start = initial_states(scene);
  Contradictions found;
  for (const BodyOverlap& one : Overlap(scene).all(start)) found.overlap = std::max(found.overlap, one.depth);
  for (const Joint& joint : scene.joints) {
    found.joint_speed = std::max(found.joint_speed, speed_apart(joint, start));
    found.joint_gap = std::max(found.joint_gap, gap_of(joint));
  }
  return found;
}

Contradictions operator+(const Contradictions& a, const Contradictions& b) {
  return {a.overlap + b.overlap, a.joint_speed + b.joint_speed, a.joint_gap + b.joint_gap};
}

Contradictions larger(const Contradictions& a, const Contradictions& b) {
  return {std::max(a.overlap, b.overlap), std::max(a.joint_speed, b.joint_speed), std::max(a.joint_gap, b.joint_gap)};
}

Contradictions stated_by(const Stepping& stepping) {
  return {stepping.contact_gap(), stepping.joint_slop / stepping.dt, stepping.joint_slop};
}

bool no_worse(const Scene& scene, const Contradictions& than) {
  constexpr double rounding = 1e-9;  // m, m/s: sums of rounded numbers
  const Contradictions found = contradictions(scene);
  return found.overlap <= than.overlap + rounding && found.joint_speed <= than.joint_speed + rounding &&
         found.joint_gap <= than.joint_gap + rounding;
}

}  // namespace plumb
