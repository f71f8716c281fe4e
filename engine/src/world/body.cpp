#include "impulse/body.h"

#include <stdexcept>
#include <string>

#include "world/world_state.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

template <class... Value>
void require_finite_values(const char* what, Value... values) {
  if (!(is_finite(values) && ...)) throw std::invalid_argument(std::string(what) + " must be finite");
}

void require_part(std::size_t part, std::size_t count) {
  if (part < count) return;
  throw std::out_of_range("Body: no part " + std::to_string(part) + "; it has " + std::to_string(count));
}

}  // namespace

BodySet& Body::bodies() const { return world_->state_->bodies; }
std::size_t Body::row() const { return world_->state_->row(id_); }

BodyType Body::type() const { return bodies().detail[row()].def.type; }

Vec2 Body::position() const {
  const std::size_t i = row();
  return to_world(bodies().pose[i], -bodies().detail[i].mass.center);
}

Real Body::angle() const { return bodies().angle[row()]; }
Rotation Body::rotation() const { return bodies().pose[row()].q; }
Vec2 Body::center() const { return bodies().pose[row()].p; }
Vec2 Body::velocity() const { return bodies().velocity_of(row()).v; }
Real Body::angular_velocity() const { return bodies().velocity_of(row()).w; }
MassData Body::mass() const { return bodies().detail[row()].mass; }
std::span<const Part> Body::parts() const { return bodies().detail[row()].parts; }
Layers Body::layers() const { return bodies().detail[row()].def.layers; }
Layers Body::layers(std::size_t part) const {
  const BodyDetail& detail = bodies().detail[row()];
  require_part(part, detail.parts.size());
  return detail.layers_of(detail.parts[part]);
}
bool Body::awake() const {
  const std::size_t i = row();
  return bodies().detail[i].inserted && bodies().asleep[i] == 0;
}
void* Body::user_data() const { return bodies().detail[row()].def.user_data; }

void Body::wake() { world_->state_->wake(row()); }

void Body::sleep() {
  const std::size_t i = row();
  World::State& state = *world_->state_;
  if (!state.settings.sleeping) throw std::logic_error("Body::sleep: sleeping is off in the world's settings");
  if (!bodies().dynamic(i)) throw std::invalid_argument("Body::sleep: only dynamic bodies sleep");
  state.sleep.put_to_sleep(i, state.solver->margin(state.settings));
}

void Body::disturb() { world_->state_->disturb(row()); }

void Body::set_pose(Vec2 position, Real angle) {
  require_finite_values("Body::set_pose: position and angle", position, angle);
  const std::size_t i = row();
  BodySet& set = bodies();
  const Rotation q(angle);
  disturb();  // the bodies at the old pose
  set.pose[i] = {position + q * set.detail[i].mass.center, q};
  set.angle[i] = angle;
  set.remainder[i] = {};
  disturb();  // the bodies at the new pose
}

void Body::set_velocity(Vec2 velocity, Real angular_velocity) {
  require_finite_values("Body::set_velocity: velocities", velocity, angular_velocity);
  const std::size_t i = row();
  if (type() == BodyType::fixed) throw std::invalid_argument("Body::set_velocity: a fixed body has no velocity");
  wake();
  bodies().velocity_of(i) = {velocity, angular_velocity};
}

void Body::set_gravity_scale(Real scale) {
  require_finite_values("Body::set_gravity_scale: the scale", scale);
  wake();
  bodies().response[row()].gravity_scale = scale;
}

void Body::set_layers(Layers layers) {
  disturb();
  bodies().set_layers(row(), layers);
}

void Body::set_part_layers(std::size_t part, const std::optional<Layers>& layers) {
  require_part(part, parts().size());
  disturb();
  bodies().set_part_layers(row(), part, layers);
}

void Body::apply_force(Vec2 force) {
  require_finite_values("Body::apply_force: the force", force);
  if (force != Vec2{}) wake();
  bodies().force[row()] += force;
}

void Body::apply_force(Vec2 force, Vec2 point) {
  require_finite_values("Body::apply_force: force and point", force, point);
  const std::size_t i = row();
  BodySet& set = bodies();
  if (force != Vec2{}) wake();
  set.force[i] += force;
  set.torque[i] += cross(point - set.pose[i].p, force);
}

void Body::apply_torque(Real torque) {
  require_finite_values("Body::apply_torque: the torque", torque);
  if (torque != 0) wake();
  bodies().torque[row()] += torque;
}

void Body::apply_impulse(Vec2 impulse, Vec2 point) {
  require_finite_values("Body::apply_impulse: impulse and point", impulse, point);
  const std::size_t i = row();
  BodySet& set = bodies();
  if (impulse != Vec2{}) wake();
  const InverseMass inverse = set.inverse_mass[i];
  set.velocity[i].v += inverse.m * impulse;
  set.velocity[i].w += inverse.i * cross(point - set.pose[i].p, impulse);
}

}  // namespace impulse::inline IMPULSE_PRECISION
