#include "impulse/debug_draw.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "world/world_state.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real normal_share = static_cast<Real>(0.02);  // length of a drawn contact normal / diagonal of the view

DrawRole role_of(BodyType type, bool awake) {
  if (type == BodyType::fixed) return DrawRole::fixed;
  if (type == BodyType::kinematic) return DrawRole::kinematic;
  return awake ? DrawRole::awake : DrawRole::asleep;
}

/// Draws the boundary over the whole view: one diagonal in each direction from the point nearest to the view's centre.
void draw_half_space(DebugDraw& draw, const Shape& shape, const Pose& pose, const Aabb& view, DrawRole role) {
  const Vec2 normal = pose.q * shape.normal(0);
  const Vec2 middle = Real{0.5} * (view.low + view.high);
  const Vec2 nearest = middle - (dot(middle - pose.p, normal) - shape.offset()) * normal;
  const Vec2 along = length(view.high - view.low) * perpendicular(normal);
  draw.segment(nearest - along, nearest + along, role);
}

void draw_shape(DebugDraw& draw, const Shape& shape, const Pose& pose, const Aabb& view, DrawRole role) {
  std::array<Vec2, Shape::max_vertices> corners;
  const auto count = static_cast<std::size_t>(shape.count());
  for (std::size_t i = 0; i < count; ++i) corners[i] = to_world(pose, shape.vertex(static_cast<int>(i)));
  const Vec2 axis = pose.q * Vec2{1, 0};
  switch (shape.type()) {
    case ShapeType::circle:
      draw.circle(corners[0], shape.radius(), axis, role);
      return;
    case ShapeType::box:
    case ShapeType::polygon:
      draw.polygon(std::span(corners).first(count), role);
      return;
    case ShapeType::capsule: {
      const Vec2 out = shape.radius() * (pose.q * shape.normal(0));
      draw.circle(corners[0], shape.radius(), axis, role);
      draw.circle(corners[1], shape.radius(), axis, role);
      draw.segment(corners[0] + out, corners[1] + out, role);
      draw.segment(corners[0] - out, corners[1] - out, role);
      return;
    }
    case ShapeType::segment:
      draw.segment(corners[0], corners[1], role);
      return;
    case ShapeType::half_space:
      draw_half_space(draw, shape, pose, view, role);
      return;
  }
}

}  // namespace

void World::debug_draw(DebugDraw& draw, const Aabb& view) {
  const State::CallbackScope scope(*state_);
  const BodySet& bodies = state_->bodies;
  query_aabb(view, [&](BodyId id, const Part& part) {
    const Body view_of_body = body(id);
    const Pose pose = bodies.pose[id.index];  // a copy: drawing may create bodies
    draw_shape(draw, part.shape, pose, view, role_of(view_of_body.type(), view_of_body.awake()));
    return true;
  });
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joined;  // a copy: drawing may destroy joints
  state_->joints.append_pairs(joined);
  for (const auto& [a, b] : joined) {
    if (bodies.detail[a].inserted && bodies.detail[b].inserted) {
      draw.segment(bodies.pose[a].p, bodies.pose[b].p, DrawRole::joint);
    }
  }
  const Real normal_length = normal_share * length(view.high - view.low);
  for (const ContactInfo& contact : contacts()) {
    if (!impulse::contains(view, contact.point)) continue;
    draw.point(contact.point, DrawRole::contact);
    draw.segment(contact.point, contact.point + normal_length * contact.normal, DrawRole::contact);
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
