#include "solver/before_step.h"

#include <algorithm>
#include <cstddef>

#include "narrow_phase/collide.h"
#include "solver/press_and_relax.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

template <class Points>
Real depth_of(const Points& points, int count) {
  Real depth = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) depth = std::max(depth, -points[i].separation);
  return depth;
}

}  // namespace

void BeforeStep::keep(const StepData& data, const Island& island, const std::vector<Velocity>& acceleration) {
  bodies_.clear();
  contacts_.clear();
  for (const std::uint32_t body : island.bodies) bodies_.push_back({data.bodies.velocity[body], acceleration[body]});
  for (const Tie& tie : island.contacts) contacts_.push_back(data.contacts[tie.contact]);
}

void BeforeStep::restore(StepData& data, const Island& island, std::vector<Velocity>& acceleration) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    data.bodies.velocity[island.bodies[i]] = bodies_[i].velocity;
    acceleration[island.bodies[i]] = bodies_[i].acceleration;
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) data.contacts[island.contacts[i].contact] = contacts_[i];
}

bool BeforeStep::drove_deep(const StepData& data, const std::vector<Pose>& start, const std::vector<Motion>& motion,
                            Real felt) const {
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const Contact& before = contacts_[i];
    if (is_deep(before.points)) continue;  // shorter sub-steps have no solution either
    const auto a = before.body_a;
    const auto b = before.body_b;
    const Manifold now = collide(data.bodies.detail[a].parts[before.part_a].shape, motion[a].from(start[a]),
                                 data.bodies.detail[b].parts[before.part_b].shape, motion[b].from(start[b]), 0);
    const Real depth = depth_of(now.points, now.count);
    if (depth > tolerated_sink && depth > depth_of(before.points, before.count) + felt) return true;
  }
  return false;
}

}  // namespace impulse::inline IMPULSE_PRECISION
