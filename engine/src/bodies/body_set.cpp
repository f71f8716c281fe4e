#include "bodies/body_set.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// The width of a polygon is least perpendicular to one of its edges.
Real thickness_of(const Shape& shape) {
  if (shape.type() == ShapeType::half_space) return Shape::unbounded;
  if (shape.count() < 3) return 2 * shape.radius();
  Real least = Shape::unbounded;
  for (int i = 0; i < shape.count(); ++i) {
    Real width = 0;
    for (int j = 0; j < shape.count(); ++j) {
      width = std::max(width, dot(shape.normal(i), shape.vertex(i) - shape.vertex(j)));
    }
    least = std::min(least, width);
  }
  return least;
}

[[noreturn]] void refuse_def(const std::string& field, const char* must) {
  throw std::invalid_argument("BodyDef: " + field + " must be " + must);
}

InverseMass inverse_of(const MassData& of) {
  return {of.mass > 0 ? 1 / of.mass : 0, of.inertia > 0 ? 1 / of.inertia : 0};
}

void check_def(const BodyDef& def) {
  if (!is_finite(def.position)) refuse_def("position", "finite");
  if (!is_finite(def.angle)) refuse_def("angle", "finite");
  if (!is_finite(def.velocity)) refuse_def("velocity", "finite");
  if (!is_finite(def.angular_velocity)) refuse_def("angular_velocity", "finite");
  if (!is_finite(def.gravity_scale)) refuse_def("gravity_scale", "finite");
  if (!is_finite(def.linear_damping) || def.linear_damping < 0) refuse_def("linear_damping", "finite and not negative");
  if (!is_finite(def.angular_damping) || def.angular_damping < 0)
    refuse_def("angular_damping", "finite and not negative");
  if (def.type == BodyType::fixed && (def.velocity != Vec2{} || def.angular_velocity != 0)) {
    refuse_def("velocity", "0 for a fixed body; use a kinematic body for prescribed motion");
  }
}

void check_part(const Part& part, const std::string& field, BodyType type) {
  const Material& m = part.material;
  if (!is_finite(m.density) || m.density < 0) refuse_def(field + ".density", "finite and not negative");
  if (!is_finite(m.static_friction) || m.static_friction < 0)
    refuse_def(field + ".static_friction", "finite and not negative");
  if (!(m.dynamic_friction >= 0 && m.dynamic_friction <= m.static_friction)) {
    refuse_def(field + ".dynamic_friction", "from 0 to the static friction");
  }
  if (!(m.restitution >= 0 && m.restitution <= 1)) refuse_def(field + ".restitution", "from 0 to 1");
  if (type == BodyType::dynamic && part.shape.type() == ShapeType::half_space) {
    refuse_def(field, "a finite shape in a dynamic body; half-spaces belong to fixed or kinematic ones");
  }
}

}  // namespace

// Parallel-axis theorem: a shape of mass m at distance d from the axis adds m d^2 to its own inertia.
MassData total_mass(std::span<const Part> parts) {
  MassData total;
  Vec2 moment;
  for (const Part& part : parts) {
    if (part.sensor) continue;
    const MassData mass = part.shape.mass(part.material.density);
    total.mass += mass.mass;
    moment += mass.mass * mass.center;
  }
  if (!(total.mass > 0)) return {};
  total.center = moment / total.mass;
  for (const Part& part : parts) {
    if (part.sensor) continue;
    const MassData mass = part.shape.mass(part.material.density);
    total.inertia += mass.inertia + mass.mass * length_squared(mass.center - total.center);
  }
  return total;
}

BodyId BodySet::add(const BodyDef& def, std::span<const Part> parts) {
  check_def(def);
  if (parts.empty()) refuse_def("parts", "at least one");
  if (parts.size() > std::numeric_limits<std::uint16_t>::max()) refuse_def("parts", "at most 65535");
  for (std::size_t p = 0; p < parts.size(); ++p) check_part(parts[p], "parts[" + std::to_string(p) + "]", def.type);

  BodyDetail made;
  made.alive = true;
  made.def = def;
  made.stored_velocity = {def.velocity, def.angular_velocity};
  if (def.type == BodyType::dynamic) {
    made.mass = total_mass(parts);
    if (!is_finite(made.mass.mass) || !is_finite(made.mass.inertia) || made.mass.mass <= 0 || made.mass.inertia <= 0) {
      refuse_def("parts",
                 "of finite mass and inertia above 0 for a dynamic body: give a shape with area and density that is no "
                 "sensor");
    }
    if (def.fixed_rotation) made.mass.inertia = 0;
  }
  Real thinnest = Shape::unbounded;
  Real farthest = 0;
  for (const Part& part : parts) {
    made.parts.push_back({part.shape.moved(-made.mass.center), part.material, part.layers, part.sensor});
    if (part.sensor) continue;
    thinnest = std::min(thinnest, thickness_of(part.shape));
    if (part.shape.type() == ShapeType::half_space) continue;
    const Real extent = made.parts.back().shape.extent();
    if (extent > farthest) farthest = extent;
  }

  if (free_rows.empty()) {
    pose.emplace_back();
    angle.emplace_back();
    remainder.emplace_back();
    velocity.emplace_back();
    inverse_mass.emplace_back();
    response.emplace_back();
    force.emplace_back();
    torque.emplace_back();
    bounding_radius.emplace_back();
    thickness.emplace_back();
    held.emplace_back();
    asleep.emplace_back();
    pile.emplace_back();
    generation.emplace_back();
    detail.emplace_back();
    free_rows.push_back(static_cast<std::uint32_t>(size() - 1));
  }
  const std::uint32_t i = free_rows.back();
  free_rows.pop_back();
  const Rotation q(def.angle);
  pose[i] = {def.position + q * made.mass.center, q};
  angle[i] = def.angle;
  remainder[i] = {};
  response[i] = {def.gravity_scale, def.linear_damping, def.angular_damping};
  force[i] = {};
  torque[i] = 0;
  bounding_radius[i] = farthest;
  thickness[i] = thinnest;
  detail[i] = std::move(made);
  return id(i);
}

void BodySet::insert(std::size_t i) {
  BodyDetail& body = detail[i];
  if (body.inserted) return;
  body.inserted = true;
  ++part_changes;
  velocity[i] = body.stored_velocity;
  inverse_mass[i] = inverse_of(body.mass);
}

void BodySet::remove(std::size_t i) {
  BodyDetail& body = detail[i];
  if (!body.inserted) return;
  body.inserted = false;
  ++part_changes;
  body.stored_velocity = velocity[i];
  velocity[i] = {};
  inverse_mass[i] = {};
  held[i] = 0;
}

void BodySet::put_to_sleep(std::size_t i) {
  velocity[i] = {};
  inverse_mass[i] = {};
  asleep[i] = 1;
  ++sleepers;
  ++sleep_changes;
}

void BodySet::wake(std::size_t i) {
  inverse_mass[i] = inverse_of(detail[i].mass);
  asleep[i] = 0;
  --sleepers;
  ++sleep_changes;
}

void BodySet::destroy(std::size_t i) {
  remove(i);
  detail[i] = {};
  ++generation[i];
  free_rows.push_back(static_cast<std::uint32_t>(i));
}

void BodySet::set_layers(std::size_t i, Layers layers) {
  detail[i].def.layers = layers;
  ++part_changes;
}

void BodySet::set_part_layers(std::size_t i, std::size_t part, const std::optional<Layers>& layers) {
  detail[i].parts[part].layers = layers;
  ++part_changes;
}

void BodySet::advance(std::size_t i, const Velocity& at, Real h) {
  pose[i].p += h * at.v;
  if (at.w == 0) return;
  angle[i] += h * at.w;
  pose[i].q = Rotation(angle[i]);
}

void BodySet::clear_forces() {
  std::fill(force.begin(), force.end(), Vec2{});
  std::fill(torque.begin(), torque.end(), Real{0});
}

}  // namespace impulse::inline IMPULSE_PRECISION
