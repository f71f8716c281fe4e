#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "contacts/ghosts.h"
#include "narrow_phase/margin.h"
#include "solver/direct_island.h"

/// The contacts of a small island: listed for a step, and found again as their bodies slide.
namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real slid_far = static_cast<Real>(0.002);  // m, that bodies slide before their contact is found again

/// 1/kg, by which the points of a contact respond to impulses along its normal, on average.
double response_of(const Contact& contact, const InverseMass& a, const InverseMass& b) {
  double sum = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(contact.count); ++i) {
    const auto arm_a = double{cross(contact.points[i].arm_a, contact.normal)};
    const auto arm_b = double{cross(contact.points[i].arm_b, contact.normal)};
    sum += double{a.m} + double{b.m} + double{a.i} * arm_a * arm_a + double{b.i} * arm_b * arm_b;
  }
  return sum / std::max(contact.count, 1);
}

/// Whether no other features can come near, however the bodies move.
bool disc_on_plane(const BodySet& bodies, const Contact& contact) {
  const ShapeType a = bodies.detail[contact.body_a].parts[contact.part_a].shape.type();
  const ShapeType b = bodies.detail[contact.body_b].parts[contact.part_b].shape.type();
  return (a == ShapeType::circle && b == ShapeType::half_space) ||
         (a == ShapeType::half_space && b == ShapeType::circle);
}

}  // namespace

/// Lists the contacts by what they are, however bodies are numbered and wherever they are: what is left to a sweep
/// where laws contradict each other, as in a wedge with friction, depends on the order.
void DirectIsland::begin_contacts() {
  StepData& data = step_->data;
  by_response_.clear();
  for (const Tie& tie : members_.contacts) {
    const Contact& contact = data.contacts[tie.contact];
    const std::vector<InverseMass>& mass = data.bodies.inverse_mass;
    by_response_.emplace_back(response_of(contact, mass[contact.body_a], mass[contact.body_b]), tie.contact);
  }
  std::sort(by_response_.begin(), by_response_.end());
  contacts_.clear();
  for (const auto& [response, index] : by_response_) {
    const Contact& from = data.contacts[index];
    DirectContact contact;
    contact.contact = index;
    contact.a = from.body_a;
    contact.b = from.body_b;
    contact.mass_a = data.bodies.inverse_mass[contact.a];
    contact.mass_b = data.bodies.inverse_mass[contact.b];
    contact.count = static_cast<std::size_t>(from.count);
    contact.static_friction = from.static_friction;
    contact.dynamic_friction = from.dynamic_friction;
    contact.restitution = from.restitution;
    contact.slips = from.slips;
    contact.lasts = from.joins || disc_on_plane(data.bodies, from);
    contact.touch = Touch(from, data.bodies, step_->start[contact.a], step_->start[contact.b]);
    contact.frame = contact.touch.at(step_->motion[contact.a], step_->motion[contact.b]);
    for (std::size_t i = 0; i < contact.count; ++i) {
      const ContactPoint& p = from.points[i];
      contact.impulse[i] = Vec2{p.normal_impulse, p.tangent_impulse} / static_cast<Real>(substeps_);
      contact.pressed[i] = contact.impulse[i] / Real{2};
    }
    contacts_.push_back(contact);
  }
}

void DirectIsland::refresh() {
  for (DirectContact& contact : contacts_) {
    find(contact);
    contact.frame = contact.touch.at(step_->motion[contact.a], step_->motion[contact.b]);
  }
  for (ActiveJoint* joint : members_.joints) joint->block = ahead(*joint, 0);
}

/// Whether the bodies have slid so far past each other since their contact was found that other corners may be near.
/// Where the ground goes on in other shapes, only the search removes ghost collisions.
bool DirectIsland::slides_far(const DirectContact& contact, const Motion& a, const Motion& b) const {
  const std::vector<Real>& reach = step_->data.bodies.bounding_radius;
  return !contact.lasts && contact.touch.moved(a, b, reach[contact.a], reach[contact.b]) >= slid_far;
}

/// The points of a contact when its bodies have moved by a and b since the start of the step. `margin`: m.
Manifold DirectIsland::collide_at(const DirectContact& contact, const Motion& a, const Motion& b, Real margin) const {
  const Contact& from = step_->data.contacts[contact.contact];
  const auto shape = [this](std::uint32_t body, std::uint16_t part) -> const Shape& {
    return step_->data.bodies.detail[body].parts[part].shape;
  };
  const Pose pose_a = a.from(step_->start[contact.a]);
  const Pose pose_b = b.from(step_->start[contact.b]);
  const Placed placed_a{shape(contact.a, from.part_a), pose_a};
  const Placed placed_b{shape(contact.b, from.part_b), pose_b};
  if (from.in_corner) {
    const Vec2 normal = contact.touch.at(a, b).normal;
    const bool a_is_ground = !pushable(contact.mass_a);
    const std::optional<Manifold> kept =
        a_is_ground ? on_face(placed_a, normal, placed_b, margin) : on_face(placed_b, -normal, placed_a, margin);
    if (kept) return a_is_ground ? *kept : flipped(*kept);
  }
  return collide(placed_a.shape, pose_a, placed_b.shape, pose_b, margin);
}

/// Whether the bodies have turned so far since their contact was found that a second corner may be near the same face.
bool DirectIsland::may_lie_down(const DirectContact& contact, const Motion& a, const Motion& b) const {
  if (contact.count != 1) return false;
  const Contact& from = step_->data.contacts[contact.contact];
  if (!from.joins || from.disc_a || from.disc_b) return false;
  const std::vector<Real>& reach = step_->data.bodies.bounding_radius;
  return contact.touch.moved(a, b, reach[contact.a], reach[contact.b]) >= slid_far;
}

/// Finds a contact again if its bodies have slid far. Where nothing is near any more it has no points: the plane of a
/// face that turns sweeps over bodies far away. Where the ground goes on in other shapes it only gains a second point
/// on the same face, which is no ghost.
void DirectIsland::find(DirectContact& contact) {
  constexpr Real same_face = static_cast<Real>(0.02);  // rad, as a drum turns in a step
  StepData& data = step_->data;
  const BodySet& bodies = data.bodies;
  const Motion& a = step_->motion[contact.a];
  const Motion& b = step_->motion[contact.b];
  if (!slides_far(contact, a, b) && !may_lie_down(contact, a, b)) return;
  Contact& found = data.contacts[contact.contact];
  const Pose pose_a = a.from(step_->start[contact.a]);
  const Pose pose_b = b.from(step_->start[contact.b]);
  const auto found_within = [&](Real t) {
    return collide_at(contact, a, b, speculative_gap(bodies, contact.a, contact.b, {sought_within, t}));
  };
  Manifold m = found_within(h_);
  if (m.count == 0) m = found_within(data.settings.dt);
  if (contact.lasts && (m.count < 2 || length(m.normal - contact.touch.at(a, b).normal) > same_face)) return;
  contact.count = static_cast<std::size_t>(m.count);
  if (m.count == 0) {
    contact.impulse = contact.pressed = {};
    contact.waits = {};
    return;
  }
  const std::array<ContactPoint, 2> last = found.points;
  const auto last_count = static_cast<std::size_t>(found.count);
  const Rotation last_a = found.found_a.q;
  const Rotation last_b = found.found_b.q;
  const DirectContact before = contact;
  contact.impulse = contact.pressed = contact.pressing = contact.total = {};
  contact.waits = {};
  counts_changed_ = counts_changed_ || found.count != m.count;
  found.count = m.count;
  found.normal = m.normal;
  found.found_a = pose_a;
  found.found_b = pose_b;
  for (std::size_t i = 0; i < contact.count; ++i) {
    ContactPoint& p = found.points[i];
    p = {};
    p.arm_a = m.points[i].point - pose_a.p;
    p.arm_b = m.points[i].point - pose_b.p;
    p.separation = found.found_separation[i] = m.points[i].separation;
    p.feature = m.points[i].feature;
  }
  // To the point that is nearest now, on either body, as one may slide over the other: which faces meet, and so the
  // names of points, may be a matter of rounding.
  for (std::size_t j = 0; j < last_count; ++j) {
    const auto away = [&](std::size_t i) {
      const Vec2 on_a = pose_a.q.inverse() * found.points[i].arm_a - last_a.inverse() * last[j].arm_a;
      const Vec2 on_b = pose_b.q.inverse() * found.points[i].arm_b - last_b.inverse() * last[j].arm_b;
      return std::min(length(on_a), length(on_b));
    };
    const std::size_t i = contact.count == 2 && away(1) < away(0) ? 1 : 0;
    contact.impulse[i] += before.impulse[j];
    contact.pressed[i] += before.pressed[j];
    contact.pressing[i] += before.pressing[j];
    contact.total[i] += before.total[j];
    contact.waits[i] = contact.waits[i] || before.waits[j];
  }
  contact.touch = Touch(found, bodies, a, b);
  contact.found_again = true;
}

}  // namespace impulse::inline IMPULSE_PRECISION
