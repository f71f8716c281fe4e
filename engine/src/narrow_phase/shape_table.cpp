#include "narrow_phase/shape_table.h"

#include <algorithm>
#include <cmath>

#include "impulse/math.h"
#include "narrow_phase/margin.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

ShapeKind kind_of(const Shape& shape) {
  if (shape.type() == ShapeType::box) return ShapeKind::box;
  return shape.type() == ShapeType::circle ? ShapeKind::disc : ShapeKind::other;
}

bool fills_little(const Aabb& bounds, Vec2 half_extents) {
  const Vec2 size = bounds.high - bounds.low;
  return size.x * size.y > 16 * half_extents.x * half_extents.y;
}

}  // namespace

void ShapeTable::update(const BodySet& bodies, const Margin& margin) {
  const bool others = part_changes_ != bodies.part_changes || sleep_changes_ != bodies.sleep_changes ||
                      pile_changes_ != bodies.pile_changes;
  if (others) list(bodies);
  fastest_ = 0;
  for (std::size_t i = 0; i < proxies_.size(); ++i) {
    if (!others && bodies.pile[proxies_[i].body] != 0) continue;
    place(i, bodies, margin, 0);
    const Vec2 v = records_[i].velocity;
    fastest_ = std::max(fastest_, std::abs(v.x) + std::abs(v.y) + records_[i].rim);
  }
  some_slanted_ = std::find(slanted_.begin(), slanted_.end(), 1) != slanted_.end();
}

void ShapeTable::update(const BodySet& bodies, const Margin& margin, std::span<const Pair> pairs) {
  if (bodies.pile_changes == 0) return;  // no pile was ever at rest
  const auto update_one = [&](std::size_t i) {
    if (bodies.pile[proxies_[i].body] != 0) place(i, bodies, margin, 0);
  };
  for (const Pair& pair : pairs) {
    update_one(pair.first);
    update_one(pair.second);
  }
}

void ShapeTable::grow(const BodySet& bodies, const Margin& margin, std::span<const Real> impact_changes) {
  for (std::size_t i = 0; i < proxies_.size(); ++i) {
    const Real change = impact_changes[proxies_[i].body];
    if (change > 0) place(i, bodies, margin, change);
  }
}

void ShapeTable::place(std::size_t i, const BodySet& bodies, const Margin& margin, Real impact_change) {
  const FixedData& fixed = fixed_[i];
  const std::size_t body = proxies_[i].body;
  const Pose& pose = bodies.pose[body];
  ShapeRecord& record = records_[i];
  record.position = pose.p;
  record.velocity = bodies.velocity[body].v;
  record.rim = rim_speed(bodies, body);
  record.impact_change = impact_change;
  record.size = fixed.size;
  Aabb bounds;
  switch (fixed.kind) {
    case ShapeKind::box:
      record.offset = pose.q * fixed.centroid;
      record.turn = pose.q * fixed.turn;
      bounds = box_bounds(record.position + record.offset, record.turn, fixed.size);
      slanted_[i] = fills_little(bounds, fixed.size) ? 1 : 0;
      break;
    case ShapeKind::disc: {
      record.offset = fixed.centroid;
      record.turn = pose.q;
      const Vec2 center = to_world(pose, fixed.centroid);
      bounds = grown(Aabb{center, center}, fixed.size.x);
      break;
    }
    case ShapeKind::other:
      bounds = fixed.part->shape.bounds(pose);
      break;
  }
  const Real speed = length(record.velocity);
  const Real by = margin.distance / 2 + margin.time * (speed + record.rim) + margin.time * impact_change;
  proxies_[i].bounds = grown(bounds, by);
  grown_by_[i] = by;
  proxies_[i].displacement = {margin.time * record.velocity, margin.time * speed};
}

/// Tests the other's bounds in the box's frame.
bool ShapeTable::beside(std::size_t box, std::size_t other) const {
  const ShapeRecord& record = records_[box];
  const Aabb& bounds = proxies_[other].bounds;
  const Vec2 half = Real{0.5} * (bounds.high - bounds.low);
  const Vec2 center = bounds.low + half;
  const Vec2 local = record.turn.inverse() * (center - (record.position + record.offset));
  const Real c = std::abs(record.turn.c);
  const Real s = std::abs(record.turn.s);
  const Real by = grown_by_[box];
  return std::abs(local.x) > record.size.x + by + (c * half.x + s * half.y) ||
         std::abs(local.y) > record.size.y + by + (s * half.x + c * half.y);
}

void ShapeTable::list(const BodySet& bodies) {
  ++version_;
  part_changes_ = bodies.part_changes;
  sleep_changes_ = bodies.sleep_changes;
  pile_changes_ = bodies.pile_changes;
  fixed_.clear();
  proxies_.clear();
  several_parts_ = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyDetail& body = bodies.detail[i];
    if (!body.inserted || bodies.asleep[i] != 0) continue;
    several_parts_ |= body.parts.size() > 1;
    for (std::size_t p = 0; p < body.parts.size(); ++p) {
      if (body.parts[p].sensor) continue;
      const Shape& shape = body.parts[p].shape;
      const ShapeKind kind = kind_of(shape);
      const Vec2 x = shape.normal(1);  // of a box, along its x axis
      fixed_.push_back({&body.parts[p], shape.centroid(), Rotation(x.x, x.y),
                        kind == ShapeKind::box ? shape.half_extents() : Vec2{shape.radius(), 0},
                        body.parts[p].material.restitution, kind});
      proxies_.push_back({{},
                          {},
                          static_cast<std::uint32_t>(i),
                          static_cast<std::uint16_t>(p),
                          body.def.type == BodyType::dynamic && bodies.pile[i] == 0,
                          body.layers_of(body.parts[p])});
    }
  }
  records_.resize(proxies_.size());
  slanted_.assign(proxies_.size(), 0);
  grown_by_.resize(proxies_.size());
}

}  // namespace impulse::inline IMPULSE_PRECISION
