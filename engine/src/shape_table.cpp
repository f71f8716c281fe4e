#include "shape_table.h"

#include "box_bounds.h"
#include "closing.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

ShapeKind kind_of(const Shape& shape) {
  if (shape.type() == ShapeType::box) return ShapeKind::box;
  return shape.type() == ShapeType::circle ? ShapeKind::disc : ShapeKind::other;
}

}  // namespace

void ShapeTable::update(const BodySet& bodies, const Margin& margin) {
  if (part_changes_ != bodies.part_changes || sleep_changes_ != bodies.sleep_changes) list(bodies);
  for (std::size_t i = 0; i < proxies_.size(); ++i) place(i, bodies, margin, 0);
}

void ShapeTable::grow(const BodySet& bodies, const Margin& margin, std::span<const Real> knocks) {
  for (std::size_t i = 0; i < proxies_.size(); ++i) {
    const Real knock = knocks[proxies_[i].body];
    if (knock > 0) place(i, bodies, margin, knock);
  }
}

void ShapeTable::place(std::size_t i, const BodySet& bodies, const Margin& margin, Real knock) {
  const Still& still = still_[i];
  const std::size_t body = proxies_[i].body;
  const Pose& pose = bodies.pose[body];
  ShapeRecord& record = records_[i];
  record.position = pose.p;
  record.velocity = bodies.velocity[body].v;
  record.rim = rim_speed(bodies, body);
  record.knock = knock;
  record.size = still.size;
  Aabb bounds;
  switch (still.kind) {
    case ShapeKind::box:
      record.offset = pose.q * still.centroid;
      record.turn = pose.q * still.turn;
      bounds = box_bounds(record.position + record.offset, record.turn, still.size);
      break;
    case ShapeKind::disc: {
      record.offset = still.centroid;
      record.turn = pose.q;
      const Vec2 center = to_world(pose, still.centroid);
      bounds = grown(Aabb{center, center}, still.size.x);
      break;
    }
    case ShapeKind::other:
      bounds = still.part->shape.bounds(pose);
      break;
  }
  const Real speed = length(record.velocity);
  const Real by = margin.distance / 2 + margin.time * (speed + record.rim);
  proxies_[i].bounds = grown(bounds, by + margin.time * knock);
  proxies_[i].way = {margin.time * record.velocity, margin.time * speed};
}

void ShapeTable::list(const BodySet& bodies) {
  part_changes_ = bodies.part_changes;
  sleep_changes_ = bodies.sleep_changes;
  still_.clear();
  proxies_.clear();
  several_parts_ = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyDetail& body = bodies.detail[i];
    if (!body.inserted || bodies.asleep[i] != 0) continue;
    several_parts_ |= body.parts.size() > 1;
    for (std::size_t p = 0; p < body.parts.size(); ++p) {
      const Shape& shape = body.parts[p].shape;
      const ShapeKind kind = kind_of(shape);
      const Vec2 x = shape.normal(1);  // of a box, along its x axis
      still_.push_back({&body.parts[p], shape.centroid(), Rotation(x.x, x.y),
                        kind == ShapeKind::box ? shape.half_extents() : Vec2{shape.radius(), 0}, kind});
      proxies_.push_back({{},
                          static_cast<std::uint32_t>(i),
                          static_cast<std::uint16_t>(p),
                          body.def.type == BodyType::dynamic,
                          body.def.layers,
                          {}});
    }
  }
  records_.resize(proxies_.size());
}

}  // namespace impulse::inline IMPULSE_PRECISION
