#include <algorithm>
#include <cmath>
#include <optional>

#include "solver/direct_island.h"
#include "solver/impact_row.h"

/// Sub-steps of a small island in one go. They are there to follow what changes: normals and arms that turn, contacts
/// that begin or cease to bear, to slide or to stick. While nothing does, forces and impulses are constant, and one
/// interval is as exact as several.
namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Of a normal (1) and of arms (of the body's reach), what rounding may change: with it, a step's drift is off by less
/// than 1e-8 m in float, 1e-12 m in double.
constexpr Real unchanged = static_cast<Real>(sizeof(Real) == 8 ? 1e-9 : 1e-5);

/// Whether what slides with one velocity is another contact at the other: it has stopped, turned back, or broken away.
bool slides_otherwise(Real then, Real now) {
  const bool slid = std::abs(then) > no_speed;
  return slid != (std::abs(now) > no_speed) || (slid && then * now < 0);
}

}  // namespace

/// Advances over several sub-steps, up to `most`, in which nothing changes. Returns over how many; 0, with nothing
/// changed, if there are not two.
int DirectIsland::glide(int most) {
  const auto driven = [](const ActiveJoint* joint) { return joint->block.driven; };
  if (most < 2 || members_.varies || solvable_ < h_) return 0;
  if (std::any_of(members_.joints.begin(), members_.joints.end(), driven)) return 0;
  const auto whole = [&](Real time) { return static_cast<int>(std::min(time / h_, static_cast<Real>(most))); };
  int count = whole(longest(static_cast<Real>(most) * h_));
  if (count < 2) return 0;
  if (const std::optional<Impact> next = next_impact(static_cast<Real>(count) * h_)) count = whole(next->time);
  if (count < 2) return 0;
  const Real h = static_cast<Real>(count) * h_;
  return seems_to_stay(h) && advance(h, {}) > 0 ? count : 0;
}

/// Whether nothing changes if bodies go on under forces and what bore them lately.
bool DirectIsland::seems_to_stay(Real h) {
  for (DirectContact& contact : contacts_) {
    const TouchFrame end = contact.touch.at(flown_motion(contact.a, h), flown_motion(contact.b, h));
    bool near = false;
    for (std::size_t i = 0; i < contact.count; ++i) {
      const bool touches = contact.frame.points[i].separation <= touching_;
      if (!touches && end.points[i].separation < 0) return false;
      near = near || touches;
      contact.sliding[i] = contact.frame.sliding(i, flown_velocity(contact.a, 0), flown_velocity(contact.b, 0));
    }
    if (!near) continue;
    if (!looks_the_same(contact, end)) return false;
    for (std::size_t i = 0; i < contact.count && contact.friction() > 0; ++i) {
      const Real then = end.sliding(i, flown_velocity(contact.a, h), flown_velocity(contact.b, h));
      if (slides_otherwise(contact.sliding[i], then)) return false;
    }
  }
  return true;
}

/// Whether nothing changes by the impulses that have been found.
bool DirectIsland::stays(Real h) const {
  const std::vector<Velocity>& velocity = step_->data.bodies.velocity;
  for (const DirectContact& contact : contacts_) {
    bool bears = false;
    for (std::size_t i = 0; i < contact.count; ++i) {
      if (!(system_.all()[contact.row + i].impulse > 0)) continue;
      if (contact.frame.points[i].separation > touching_) return false;
      bears = true;
    }
    if (!bears) continue;
    const Motion a = motion_after(contact.a, h);
    const Motion b = motion_after(contact.b, h);
    const TouchFrame end = contact.touch.at(a, b);
    if (!looks_the_same(contact, end) || (slides_far(contact, a, b) && !is_found_there(contact, end, a, b)))
      return false;
    for (std::size_t i = 0; i < contact.count && contact.friction() > 0; ++i) {
      // Halfway, and at the end.
      const Real mean = end.sliding(i, velocity[contact.a], velocity[contact.b]);
      const Real last = 2 * mean - contact.sliding[i];
      if (slides_otherwise(contact.sliding[i], mean) || slides_otherwise(mean, last)) return false;
    }
  }
  return std::all_of(members_.joints.begin(), members_.joints.end(), [&](const ActiveJoint* joint) {
    const JointBlock& now = joint->block;
    const JointBlock then = ahead(*joint, h);
    const auto same = [&](const JointRow& one, const JointRow& other) {
      return length(one.axis - other.axis) <= unchanged && same_arm(one.arm_a - other.arm_a, now.inv_mass_a, now.a) &&
             same_arm(one.arm_b - other.arm_b, now.inv_mass_b, now.b);
    };
    for (std::size_t i = 0; i < static_cast<std::size_t>(now.equations); ++i) {
      if (!same(now.equation[i], then.equation[i])) return false;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(now.stops); ++i) {
      if (!same(now.stop[i], then.stop[i])) return false;
    }
    return true;
  });
}

/// Whether an arm that differs by so much, in m, is the same to the body.
bool DirectIsland::same_arm(Real change, const InverseMass& mass, std::uint32_t body) const {
  return !pushable(mass) || std::abs(change) <= unchanged * step_->data.bodies.bounding_radius[body] + rounding_;
}

/// Whether the normal and the arms are those of now.
bool DirectIsland::looks_the_same(const DirectContact& contact, const TouchFrame& then) const {
  if (length(then.normal - contact.frame.normal) > unchanged) return false;
  for (std::size_t i = 0; i < contact.count; ++i) {
    const PointArms& p = contact.frame.points[i];
    const PointArms& q = then.points[i];
    const bool same = same_arm(q.cross_a - p.cross_a, contact.mass_a, contact.a) &&
                      same_arm(q.dot_a - p.dot_a, contact.mass_a, contact.a) &&
                      same_arm(q.cross_b - p.cross_b, contact.mass_b, contact.b) &&
                      same_arm(q.dot_b - p.dot_b, contact.mass_b, contact.b);
    if (!same) return false;
  }
  return true;
}

/// Whether a contact has the points that it is thought to have when its bodies have moved by a and b: no other corners
/// have come round.
bool DirectIsland::is_found_there(const DirectContact& contact, const TouchFrame& frame, const Motion& a,
                                  const Motion& b) const {
  const bool by_a = pushable(contact.mass_a);
  const std::uint32_t body = by_a ? contact.a : contact.b;
  const Vec2 centre = step_->start[body].p + (by_a ? a.d : b.d);
  const Real near = unchanged * step_->data.bodies.bounding_radius[body] + touching_;
  const Manifold found = collide_at(contact, a, b, sought_within);
  if (static_cast<std::size_t>(found.count) != contact.count) return false;
  for (std::size_t i = 0; i < contact.count; ++i) {
    const PointArms& p = frame.points[i];
    const Vec2 arm = by_a ? p.dot_a * frame.normal - p.cross_a * perpendicular(frame.normal)
                          : p.dot_b * frame.normal - p.cross_b * perpendicular(frame.normal);
    const auto away = [&](std::size_t j) { return length(found.points[j].point - (centre + arm)); };
    if (std::min(away(0), away(contact.count - 1)) > near) return false;
  }
  return true;
}

}  // namespace impulse::inline IMPULSE_PRECISION
