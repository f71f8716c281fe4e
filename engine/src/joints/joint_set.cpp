#include "joints/joint_set.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

void check_joint_bodies(BodyId a, BodyId b, const BodySet& bodies) {
  for (const BodyId id : {a, b}) {
    if (!bodies.contains(id)) throw std::out_of_range("Joint: no body " + std::to_string(id.index));
  }
  if (a == b) throw std::invalid_argument("Joint: a and b must be different bodies");
  if (bodies.detail[a.index].def.type != BodyType::dynamic && bodies.detail[b.index].def.type != BodyType::dynamic) {
    throw std::invalid_argument("Joint: a or b must be dynamic");
  }
}

/// Adds the spring of a soft joint to the forces; returns nullopt for any other joint.
std::optional<ForceId> add_spring(const Joint& joint, const BodySet& bodies, ForceField& forces) {
  const auto* soft = std::get_if<DistanceJoint>(&joint);
  if (soft == nullptr || soft->stiffness == 0) return {};
  const auto local = [&bodies](BodyId id, Vec2 anchor) {
    const std::size_t i = id.index;
    return to_local(bodies.pose[i], anchor) + bodies.detail[i].mass.center;
  };
  return forces.add(Spring{soft->a, soft->b, local(soft->a, soft->anchor_a), local(soft->b, soft->anchor_b),
                           soft->stiffness, soft->length, soft->damping},
                    bodies);
}

}  // namespace

JointId JointSet::add(const Joint& joint, const BodySet& bodies, ForceField& forces) {
  const auto [a, b] = std::visit([](const auto& j) { return std::pair(j.a, j.b); }, joint);
  check_joint_bodies(a, b, bodies);
  auto model = std::visit([&](const auto& j) { return model_of(j, bodies); }, joint);
  if (free_slots_.empty()) {
    slots_.emplace_back();
    free_slots_.push_back(static_cast<std::uint32_t>(slots_.size() - 1));
  }
  const std::uint32_t i = free_slots_.back();
  free_slots_.pop_back();
  Slot& slot = slots_[i];
  slot.a = a;
  slot.b = b;
  slot.model = std::move(model);
  slot.block = {};
  slot.spring = add_spring(joint, bodies, forces);
  partners_.resize(std::max<std::size_t>(partners_.size(), std::max(a.index, b.index) + 1));
  partners_[a.index].push_back(b.index);
  partners_[b.index].push_back(a.index);
  return {i, slot.generation};
}

bool JointSet::contains(JointId id) const {
  return id.index < slots_.size() && slots_[id.index].model && slots_[id.index].generation == id.generation;
}

void JointSet::remove(JointId id, ForceField& forces) {
  require(id);
  if (slots_[id.index].spring) forces.remove(*slots_[id.index].spring);
  free_slot(id.index);
}

void JointSet::set_motor(JointId id, const std::optional<Motor>& motor) {
  require(id);
  Slot& slot = slots_[id.index];
  slot.model = slot.model->with_motor(motor);
  if (motor) return;
  slot.block.driven = false;
  slot.block.motor = {};
}

void JointSet::set_limits(JointId id, const std::optional<Limits>& limits) {
  require(id);
  Slot& slot = slots_[id.index];
  slot.model = slot.model->with_limits(limits);
  slot.block.stops = 0;
  slot.block.stop = {};
}

void JointSet::forget(BodyId body) {
  if (body.index >= partners_.size() || partners_[body.index].empty()) return;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (slots_[i].model && (slots_[i].a == body || slots_[i].b == body)) free_slot(i);
  }
}

void JointSet::free_slot(std::size_t slot) {
  const std::uint32_t a = slots_[slot].a.index;
  const std::uint32_t b = slots_[slot].b.index;
  const auto part = [this](std::uint32_t from, std::uint32_t other) {
    std::vector<std::uint32_t>& partners = partners_[from];
    partners.erase(std::find(partners.begin(), partners.end(), other));
  };
  part(a, b);
  part(b, a);
  slots_[slot].model.reset();
  ++slots_[slot].generation;
  free_slots_.push_back(static_cast<std::uint32_t>(slot));
}

bool JointSet::connects(std::uint32_t a, std::uint32_t b) const {
  if (std::max(a, b) >= partners_.size()) return false;
  if (partners_[a].size() > partners_[b].size()) std::swap(a, b);
  return std::find(partners_[a].begin(), partners_[a].end(), b) != partners_[a].end();
}

std::span<const std::uint32_t> JointSet::partners(std::uint32_t body) const {
  return body < partners_.size() ? std::span(partners_[body]) : std::span<const std::uint32_t>();
}

void JointSet::append_pairs(std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) const {
  for (const Slot& slot : slots_) {
    if (slot.model) pairs.emplace_back(slot.a.index, slot.b.index);
  }
}

std::vector<ActiveJoint>& JointSet::activate(const BodySet& bodies) {
  active_.clear();
  active_slot_.clear();
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    Slot& slot = slots_[i];
    if (!slot.model) continue;
    const std::uint32_t a = slot.a.index;
    const std::uint32_t b = slot.b.index;
    if (!bodies.detail[a].inserted || !bodies.detail[b].inserted) continue;
    if (bodies.asleep[a] != 0 || bodies.asleep[b] != 0) continue;
    slot.block.a = a;
    slot.block.b = b;
    slot.block.inv_mass_a = bodies.inverse_mass[a];
    slot.block.inv_mass_b = bodies.inverse_mass[b];
    slot.model->write({bodies.pose[a], bodies.angle[a]}, {bodies.pose[b], bodies.angle[b]}, slot.block);
    active_.push_back({slot.model.get(), slot.block});
    active_slot_.push_back(i);
  }
  return active_;
}

void JointSet::store() {
  for (std::size_t i = 0; i < active_.size(); ++i) slots_[active_slot_[i]].block = active_[i].block;
}

std::pair<std::uint32_t, std::uint32_t> JointSet::bodies_of(JointId id) const {
  require(id);
  return {slots_[id.index].a.index, slots_[id.index].b.index};
}

void JointSet::require(JointId id) const {
  if (contains(id)) return;
  throw std::out_of_range("World: no joint " + std::to_string(id.index) +
                          "; it was removed or one of its bodies was destroyed");
}

Vec2 JointSet::impulse(JointId id) const {
  require(id);
  Vec2 sum;
  for_each_row(slots_[id.index].block, [&sum](const JointRow& row) { sum += row.impulse * row.axis; });
  return sum;
}

}  // namespace impulse::inline IMPULSE_PRECISION
