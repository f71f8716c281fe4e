#include <vector>

#include "c_api/convert.h"

namespace impulse::c_api {

namespace {

impulse_shape shape_with(impulse_shape_type type, std::span<const impulse_vec2> points) {
  impulse_shape shape{};
  shape.type = type;
  shape.point_count = points.size();
  const std::size_t room = std::min(points.size(), std::size(shape.points));
  std::copy_n(points.begin(), room, std::begin(shape.points));
  shape.material = impulse_default_material();
  return shape;
}

Part part_from_c(const impulse_shape& shape) {
  Part part{shape_from_c(shape), from_c(shape.material)};
  if (shape.has_layers) part.layers = from_c(shape.layers);
  part.sensor = shape.sensor;
  return part;
}

BodyDef def_from_c(const impulse_body_def& from) {
  if (static_cast<int>(from.type) < 0 || from.type > IMPULSE_DYNAMIC) {
    throw std::invalid_argument("the type of the body is unknown");
  }
  BodyDef to;
  to.type = static_cast<BodyType>(from.type);
  to.position = from_c(from.position);
  to.angle = from.angle;
  to.velocity = from_c(from.velocity);
  to.angular_velocity = from.angular_velocity;
  to.gravity_scale = from.gravity_scale;
  to.linear_damping = from.linear_damping;
  to.angular_damping = from.angular_damping;
  to.fixed_rotation = from.fixed_rotation;
  to.bullet = from.bullet;
  to.layers = from_c(from.layers);
  to.user_data = from.user_data;
  return to;
}

impulse_status create(impulse_world* world, const impulse_body_def* def, std::span<const Part> parts,
                      impulse_body_id* id) {
  return guarded([&] {
    impulse_body_id& to = given(id, "the place for the handle");
    to = to_c(world_of(world).create_body(def_from_c(given(def, "the definition of the body")), parts));
  });
}

}  // namespace

Shape shape_from_c(const impulse_shape& from) {
  const std::size_t most = std::size(from.points);
  if (from.point_count > most) {
    throw std::invalid_argument("a shape has at most 8 points, got " + std::to_string(from.point_count));
  }
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < from.point_count; ++i) points.push_back(from_c(from.points[i]));
  const auto point = [&](std::size_t i) { return from_c(from.points[i]); };
  switch (from.type) {
    case IMPULSE_CIRCLE:
      return Shape::circle(from.radius, point(0));
    case IMPULSE_BOX:
      return Shape::box(from_c(from.half_extents), point(0), from.angle);
    case IMPULSE_POLYGON:
      return Shape::polygon(points);
    case IMPULSE_CAPSULE:
      return Shape::capsule(point(0), point(1), from.radius);
    case IMPULSE_SEGMENT:
      return Shape::segment(point(0), point(1));
    case IMPULSE_HALF_SPACE:
      return Shape::half_space(point(0), from.offset);
  }
  throw std::invalid_argument("the type of the shape is unknown");
}

}  // namespace impulse::c_api

using namespace impulse::c_api;

impulse_material impulse_default_material() {
  const impulse::Material m;
  return {m.density, m.static_friction, m.dynamic_friction, m.restitution};
}

impulse_shape impulse_circle(float radius, impulse_vec2 center) {
  impulse_shape shape = shape_with(IMPULSE_CIRCLE, {&center, 1});
  shape.radius = radius;
  return shape;
}

impulse_shape impulse_box(impulse_vec2 half_extents, impulse_vec2 center, float angle) {
  impulse_shape shape = shape_with(IMPULSE_BOX, {&center, 1});
  shape.half_extents = half_extents;
  shape.angle = angle;
  return shape;
}

impulse_shape impulse_polygon(const impulse_vec2* points, size_t count) {
  return shape_with(IMPULSE_POLYGON, {points, points == nullptr ? 0 : count});
}

impulse_shape impulse_capsule(impulse_vec2 from, impulse_vec2 to, float radius) {
  const impulse_vec2 ends[] = {from, to};
  impulse_shape shape = shape_with(IMPULSE_CAPSULE, ends);
  shape.radius = radius;
  return shape;
}

impulse_shape impulse_segment(impulse_vec2 from, impulse_vec2 to) {
  const impulse_vec2 ends[] = {from, to};
  return shape_with(IMPULSE_SEGMENT, ends);
}

impulse_shape impulse_half_space(impulse_vec2 normal, float offset) {
  impulse_shape shape = shape_with(IMPULSE_HALF_SPACE, {&normal, 1});
  shape.offset = offset;
  return shape;
}

impulse_body_def impulse_default_body() {
  const impulse::BodyDef from;
  impulse_body_def to{};
  to.type = IMPULSE_DYNAMIC;
  to.gravity_scale = from.gravity_scale;
  to.layers = to_c(from.layers);
  return to;
}

impulse_status impulse_create_body(impulse_world* world, const impulse_body_def* def, const impulse_shape* shapes,
                                   size_t shape_count, impulse_body_id* id) {
  std::vector<impulse::Part> parts;
  const impulse_status status = guarded([&] {
    if (shape_count > 0) given(shapes, "the list of shapes");
    for (std::size_t i = 0; i < shape_count; ++i) parts.push_back(part_from_c(shapes[i]));
  });
  return status == IMPULSE_OK ? create(world, def, parts, id) : status;
}

impulse_status impulse_create_chain(impulse_world* world, const impulse_body_def* def, const impulse_vec2* points,
                                    size_t point_count, bool loop, const impulse_material* material,
                                    impulse_body_id* id) {
  std::vector<impulse::Part> parts;
  const impulse_status status = guarded([&] {
    if (point_count > 0) given(points, "the list of points");
    std::vector<impulse::Vec2> line;
    for (std::size_t i = 0; i < point_count; ++i) line.push_back(from_c(points[i]));
    const impulse::Material of = material == nullptr ? impulse::Material{} : from_c(*material);
    for (const impulse::Shape& segment : impulse::Shape::chain(line, loop)) parts.push_back({segment, of});
  });
  return status == IMPULSE_OK ? create(world, def, parts, id) : status;
}

impulse_status impulse_destroy_body(impulse_world* world, impulse_body_id id) {
  return guarded([&] { world_of(world).destroy_body(from_c(id)); });
}

bool impulse_has_body(const impulse_world* world, impulse_body_id id) {
  return world != nullptr && world->world.contains(from_c(id));
}

impulse_status impulse_bodies(const impulse_world* world, impulse_body_id* into, size_t capacity, size_t* count) {
  return guarded(
      [&] { list(world_of(world).bodies(), into, capacity, count, [](impulse::BodyId id) { return to_c(id); }); });
}

impulse_status impulse_get_body(impulse_world* world, impulse_body_id id, impulse_body* body) {
  return guarded([&] {
    const impulse::Body from = world_of(world).body(from_c(id));
    impulse_body& to = given(body, "the place for the body");
    to.type = static_cast<impulse_body_type>(from.type());
    to.position = to_c(from.position());
    to.angle = from.angle();
    to.center = to_c(from.center());
    to.velocity = to_c(from.velocity());
    to.angular_velocity = from.angular_velocity();
    to.mass = from.mass().mass;
    to.inertia = from.mass().inertia;
    to.awake = from.awake();
    to.user_data = from.user_data();
  });
}

impulse_status impulse_set_pose(impulse_world* world, impulse_body_id id, impulse_vec2 position, float angle) {
  return guarded([&] { world_of(world).body(from_c(id)).set_pose(from_c(position), angle); });
}

impulse_status impulse_set_velocity(impulse_world* world, impulse_body_id id, impulse_vec2 velocity,
                                    float angular_velocity) {
  return guarded([&] { world_of(world).body(from_c(id)).set_velocity(from_c(velocity), angular_velocity); });
}

impulse_status impulse_set_layers(impulse_world* world, impulse_body_id id, impulse_layers layers) {
  return guarded([&] { world_of(world).body(from_c(id)).set_layers(from_c(layers)); });
}

impulse_status impulse_apply_force(impulse_world* world, impulse_body_id id, impulse_vec2 force, impulse_vec2 point) {
  return guarded([&] { world_of(world).body(from_c(id)).apply_force(from_c(force), from_c(point)); });
}

impulse_status impulse_apply_torque(impulse_world* world, impulse_body_id id, float torque) {
  return guarded([&] { world_of(world).body(from_c(id)).apply_torque(torque); });
}

impulse_status impulse_apply_impulse(impulse_world* world, impulse_body_id id, impulse_vec2 impulse,
                                     impulse_vec2 point) {
  return guarded([&] { world_of(world).body(from_c(id)).apply_impulse(from_c(impulse), from_c(point)); });
}

impulse_status impulse_wake(impulse_world* world, impulse_body_id id) {
  return guarded([&] { world_of(world).body(from_c(id)).wake(); });
}
