#include "bodies/force_field.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "bodies/generators.h"

namespace impulse::inline IMPULSE_PRECISION {

void ForceField::accelerations(const BodySet& bodies, Real implicit, std::vector<Velocity>& out) const {
  const std::size_t n = bodies.size();
  out.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const InverseMass inverse = bodies.inverse_mass[i];
    const Vec2 falling = inverse.m > 0 ? bodies.response[i].gravity_scale * gravity : Vec2{};
    out[i] = {falling + inverse.m * bodies.force[i], inverse.i * bodies.torque[i]};
  }
  for (const Slot& slot : slots_) {
    if (!slot.force) continue;
    std::visit([&](const auto& force) { accelerate(force, bodies, out); }, *slot.force);
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (bodies.inverse_mass[i].m == 0) continue;
    const Velocity& velocity = bodies.velocity[i];
    const Real linear = bodies.response[i].linear_damping;
    const Real angular = bodies.response[i].angular_damping;
    if (linear > 0) out[i].v = (out[i].v - linear * velocity.v) / (1 + implicit * linear);
    if (angular > 0) out[i].w = (out[i].w - angular * velocity.w) / (1 + implicit * angular);
  }
}

bool ForceField::vary(const BodySet& bodies) const {
  const auto varies = [](const Slot& slot) {
    return slot.force && !std::holds_alternative<ConstantForce>(*slot.force);
  };
  const auto damped = [](const Response& r) { return r.linear_damping > 0 || r.angular_damping > 0; };
  return std::any_of(slots_.begin(), slots_.end(), varies) ||
         std::any_of(bodies.response.begin(), bodies.response.end(), damped);
}

ForceId ForceField::add(const Force& force, const BodySet& bodies) {
  std::visit([&bodies](const auto& generator) { check(generator, bodies); }, force);
  if (free_slots_.empty()) {
    slots_.emplace_back();
    free_slots_.push_back(static_cast<std::uint32_t>(slots_.size() - 1));
  }
  const std::uint32_t i = free_slots_.back();
  free_slots_.pop_back();
  slots_[i].force = force;
  return {i, slots_[i].generation};
}

bool ForceField::contains(ForceId id) const {
  return id.index < slots_.size() && slots_[id.index].force && slots_[id.index].generation == id.generation;
}

void ForceField::need(ForceId id) const {
  if (!contains(id))
    throw std::out_of_range("World: no force " + std::to_string(id.index) + "; it or its body is gone");
}

std::vector<std::uint32_t> ForceField::bodies_of(ForceId id, const BodySet& bodies) const {
  need(id);
  std::vector<std::uint32_t> rows;
  std::visit([&](const auto& force) { append_bodies(force, bodies, rows); }, *slots_[id.index].force);
  return rows;
}

void ForceField::append_ties(const BodySet& bodies, std::vector<std::pair<std::uint32_t, std::uint32_t>>& out) const {
  std::vector<std::uint32_t> rows;
  for (const Slot& slot : slots_) {
    if (!slot.force) continue;
    rows.clear();
    std::visit([&](const auto& force) { append_bodies(force, bodies, rows); }, *slot.force);
    for (std::size_t i = 1; i < rows.size(); ++i) out.emplace_back(rows[0], rows[i]);
  }
}

void ForceField::remove(ForceId id) {
  need(id);
  end(id.index);
}

void ForceField::forget(BodyId body) {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const auto names_it = [body](const auto& generator) { return names(generator, body); };
    if (slots_[i].force && std::visit(names_it, *slots_[i].force)) end(i);
  }
}

void ForceField::end(std::size_t slot) {
  slots_[slot].force.reset();
  ++slots_[slot].generation;
  free_slots_.push_back(static_cast<std::uint32_t>(slot));
}

}  // namespace impulse::inline IMPULSE_PRECISION
