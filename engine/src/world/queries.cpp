#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "shapes/distance.h"
#include "world/world_state.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Calls back for each part of the inserted bodies that passes the test, until the callback returns false. Bodies that
/// the callback creates are inserted only after it returns, so they are not visited.
template <class Test>
void visit_parts(const BodySet& bodies, const World::QueryCallback& callback, const Test& test) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.detail[i].inserted) continue;
    for (std::size_t p = 0; p < bodies.detail[i].parts.size(); ++p) {
      const Part& part = bodies.detail[i].parts[p];
      if (test(part.shape, bodies.pose[i]) && !callback(bodies.id(i), part)) return;
    }
  }
}

bool meets_query(const BodyDetail& body, std::size_t part, std::uint32_t layers) {
  return !body.parts[part].sensor && (body.layers_of(body.parts[part]).category & layers) != 0;
}

/// All parts that the ray enters, sorted by bodies and parts.
std::vector<BodyHit> find_hits(const BodySet& bodies, Vec2 from, Vec2 to, std::uint32_t layers) {
  if (!is_finite(from) || !is_finite(to)) throw std::invalid_argument("World::ray_cast: both points must be finite");
  std::vector<BodyHit> found;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyDetail& body = bodies.detail[i];
    if (!body.inserted) continue;
    const Pose& pose = bodies.pose[i];
    for (std::size_t p = 0; p < body.parts.size(); ++p) {
      if (!meets_query(body, p, layers)) continue;
      RayHit hit;
      if (!ray_cast(body.parts[p].shape, to_local(pose, from), to_local(pose, to), hit)) continue;
      found.push_back({bodies.id(i), p, hit.fraction, to_world(pose, hit.point), pose.q * hit.normal});
    }
  }
  return found;
}

// Hits at the same point are ordered by body, so the result does not depend on the sorting algorithm.
bool nearer(const BodyHit& left, const BodyHit& right) {
  return std::tie(left.fraction, left.body.index, left.part) < std::tie(right.fraction, right.body.index, right.part);
}

/// Where a contact pushes: between its points on both bodies, which may have slid apart since they were found; on the
/// one that can be pushed if the other cannot.
Vec2 acts_at(const BodySet& bodies, const Contact& contact, const ContactPoint& point) {
  const Vec2 on_a = bodies.pose[contact.body_a].p + point.arm_a;
  const Vec2 on_b = bodies.pose[contact.body_b].p + point.arm_b;
  if (!bodies.pushable(contact.body_a)) return on_b;
  if (!bodies.pushable(contact.body_b)) return on_a;
  return Real{0.5} * (on_a + on_b);
}

}  // namespace

void World::ray_cast(Vec2 from, Vec2 to, const RayCallback& callback) {
  const State::CallbackScope scope(*state_);
  std::vector<BodyHit> found = find_hits(state_->bodies, from, to, ~std::uint32_t{0});
  std::sort(found.begin(), found.end(), nearer);
  for (const BodyHit& hit : found) {
    if (!callback(hit)) return;
  }
}

std::optional<BodyHit> World::ray_cast(Vec2 from, Vec2 to, std::uint32_t layers) const {
  const std::vector<BodyHit> found = find_hits(state_->bodies, from, to, layers);
  const auto first = std::min_element(found.begin(), found.end(), nearer);
  if (first == found.end()) return std::nullopt;
  return *first;
}

void World::query_aabb(const Aabb& box, const QueryCallback& callback) {
  const State::CallbackScope scope(*state_);
  visit_parts(state_->bodies, callback,
              [&box](const Shape& shape, const Pose& pose) { return overlap(box, shape.bounds(pose)); });
}

void World::query_point(Vec2 point, const QueryCallback& callback) {
  const State::CallbackScope scope(*state_);
  visit_parts(state_->bodies, callback,
              [point](const Shape& shape, const Pose& pose) { return shape.contains(to_local(pose, point)); });
}

std::optional<BodyHit> World::shape_cast(const Shape& shape, const Pose& start, Vec2 by, std::uint32_t layers) const {
  if (shape.type() == ShapeType::half_space) throw std::invalid_argument("World::shape_cast: a half-space cannot move");
  if (!is_finite(start.p) || !is_finite(by)) {
    throw std::invalid_argument("World::shape_cast: start and displacement must be finite");
  }
  const Aabb path = merged(shape.bounds(start), shape.bounds({start.p + by, start.q}));
  const BodySet& bodies = state_->bodies;
  std::optional<BodyHit> first;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyDetail& body = bodies.detail[i];
    if (!body.inserted) continue;
    for (std::size_t p = 0; p < body.parts.size(); ++p) {
      if (!meets_query(body, p, layers)) continue;
      const Shape& other = body.parts[p].shape;
      if (!overlap(path, other.bounds(bodies.pose[i]))) continue;
      const std::optional<RayHit> hit = impulse::shape_cast(shape, start, by, other, bodies.pose[i]);
      if (!hit || (first && first->fraction <= hit->fraction)) continue;
      first = BodyHit{bodies.id(i), p, hit->fraction, hit->point, hit->normal};
    }
  }
  return first;
}

std::span<const ContactInfo> World::contacts() const {
  const BodySet& bodies = state_->bodies;
  std::vector<ContactInfo>& infos = state_->listed_contacts;
  infos.clear();
  std::vector<Contact>& of_piles = state_->contacts_of_piles;
  of_piles.clear();
  if (const RestingPiles* resting = state_->solver->resting()) resting->append(bodies, of_piles);
  state_->contacts.all(of_piles, state_->sorted_contacts);
  for (const Contact* contact : state_->sorted_contacts) {
    for (std::size_t p = 0; p < static_cast<std::size_t>(contact->count); ++p) {
      const ContactPoint& point = contact->points[p];
      if (point.separation > 0 && point.total_normal_impulse == 0) continue;
      infos.push_back({bodies.id(contact->body_a), bodies.id(contact->body_b), acts_at(bodies, *contact, point),
                       contact->normal, point.separation, point.total_normal_impulse, point.total_tangent_impulse});
    }
  }
  return infos;
}

SensorEvents World::sensor_events() const { return state_->sensors.events(); }

ContactEvents World::contact_events() const {
  if (!state_->settings.contact_events) {
    throw std::logic_error("World::contact_events: turn on Settings::contact_events first");
  }
  return state_->touches.events();
}

}  // namespace impulse::inline IMPULSE_PRECISION
