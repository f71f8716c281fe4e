#include "world/continuous_collision.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "contacts/part_filter.h"
#include "core/method_list.h"
#include "shapes/distance.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// m, overlap left at the time of impact, so that the next step finds the contact; less for thin bodies.
constexpr Real overlap_left = static_cast<Real>(0.001);
/// m, the distance at which two shapes count as touching.
constexpr Real touching = static_cast<Real>(0.0001);
/// Conservative advancement converges geometrically unless a body spins extremely fast. After this many advances it
/// ends early, which is safe.
constexpr int most_advances = 64;

/// m, radius of the core circle: half of half the thickness. The core stays on its side of whatever the body touches.
Real core_radius(Real thickness) { return std::max(thickness / 4, touching); }

/// m, the farthest distance at which rotation moves a point of the shape: a rounded shape is a hull grown by a disc,
/// and rotating a disc changes nothing.
Real hull_radius(const Shape& shape) {
  Real farthest = 0;
  for (int i = 0; i < shape.count(); ++i) farthest = std::max(farthest, length(shape.vertex(i)));
  return farthest;
}

/// m, a lower bound for the distance of a point from the shape: that from the farthest face it is in front of.
Real height_over(const Shape& shape, Vec2 local) {
  if (shape.type() == ShapeType::half_space) return dot(shape.normal(0), local) - shape.offset();
  Real highest = 0;
  for (int i = 0; i < shape.count(); ++i) {
    highest = std::max(highest, dot(shape.normal(i), local - shape.vertex(i)) - shape.radius());
  }
  return highest;
}

}  // namespace

/// The motion of a body through a step: uniform translation and rotation as far as its stop.
struct ContinuousCollision::Path {
  Pose start;
  Vec2 translation;
  Real angle = 0;
  Real rotation = 0;
  Stop stop;

  /// The pose at time t, a share of the step.
  Pose at(Real t) const {
    const Real moved = std::min(t, stop.time);
    const Real turned = stop.keeps_turning ? t : moved;
    return {start.p + moved * translation, rotation == 0 ? start.q : Rotation(angle + turned * rotation)};
  }
  Aabb bounds(const Shape& shape, Real radius) const {
    const Aabb ends = merged(shape.bounds(at(0)), shape.bounds(at(1)));
    // In between, a rotating shape may extend farther, in proportion to its radius.
    return rotation == 0 ? ends : grown(ends, std::min(std::abs(rotation), Real{2}) * radius);
  }
  bool moves() const { return !(translation == Vec2{} && rotation == 0); }
  /// m, upper bound for the displacement of points within a radius of the centre of mass.
  Real displacement(Real radius) const { return length(translation) + std::abs(rotation) * radius; }
};

struct ContinuousCollision::MovingShape {
  const Shape& shape;
  const Path& path;
  Real radius = hull_radius(shape);

  /// m per step, upper bound for the speed of its points along n.
  Real speed_along(Vec2 n) const {
    const Real straight = dot(path.translation, n);
    return (path.stop.time < 1 ? std::max(straight, Real{0}) : straight) + std::abs(path.rotation) * radius;
  }

  /// The time of impact as a share of the step, 1 if the two don't meet, by conservative advancement (B. Mirtich 1996):
  /// at a distance d along n, nothing can meet before the gap closes at its greatest possible speed,
  ///
  ///     t += d / (speed of a along n + speed of b along -n).
  ///
  /// Stops at an overlap of `depth` (m), or just short of touching if that is 0. Returns nullopt if they touch at the
  /// start.
  static std::optional<Real> time_of_impact(const MovingShape& a, const MovingShape& b, Real depth) {
    Real t = 0;
    for (int i = 0; i < most_advances; ++i) {
      const Gap gap = distance(a.shape, a.path.at(t), b.shape, b.path.at(t));
      if (gap.distance == 0) {
        if (t == 0) return std::nullopt;
        return t;
      }
      const Real closing_speed = a.speed_along(gap.normal) + b.speed_along(-gap.normal);
      if (closing_speed <= 0) return Real{1};
      if (gap.distance <= touching) {
        return depth > 0 ? std::min(t + (gap.distance + depth) / closing_speed, Real{1}) : t;
      }
      t += (gap.distance - touching / 2) / closing_speed;  // not the whole gap: rounding must not make them overlap
      if (t >= 1) return Real{1};
    }
    return t;
  }
};

ContinuousCollision::ContinuousCollision() : broad_phase_(MethodList<BroadPhase>::make("auto")) {}

void ContinuousCollision::store_start(const BodySet& bodies) {
  start_ = bodies.pose;
  start_angle_ = bodies.angle;
}

ContinuousCollision::Path ContinuousCollision::path(const BodySet& bodies, std::size_t i) const {
  return {start_[i], bodies.pose[i].p - start_[i].p, start_angle_[i], bodies.angle[i] - start_angle_[i], stops_[i]};
}

void ContinuousCollision::clamp_to_impacts(BodySet& bodies, const Passing& passing, Continuous mode) {
  if (!classify_motion(bodies, mode)) return;
  if (hits_dynamic_) {
    candidates_.resize(bodies.size());
    std::iota(candidates_.begin(), candidates_.end(), 0U);
  }
  stops_.resize(bodies.size());
  for (const std::uint32_t i : candidates_) stops_[i] = {};
  find_pairs(bodies, passing);
  stop_at_immovable(bodies);
  if (hits_dynamic_) stop_at_each_other(bodies);
  for (const std::uint32_t i : candidates_) {
    if (stops_[i].time < 1) clamp_body(bodies, i);
  }
}

/// Returns whether any body is fast.
bool ContinuousCollision::classify_motion(const BodySet& bodies, Continuous mode) {
  list_candidates(bodies);
  motion_class_.assign(bodies.size(), MotionClass::slow);
  hits_dynamic_ = false;
  bool any = false;
  for (const std::uint32_t i : candidates_) {
    const Real moved = length(bodies.pose[i].p - start_[i].p);
    const Real displacement = moved + std::abs(bodies.angle[i] - start_angle_[i]) * bodies.bounding_radius[i];
    if (displacement <= bodies.thickness[i] / 2) continue;
    const BodyDetail& body = bodies.detail[i];
    any = true;
    const bool movable = body.def.type == BodyType::dynamic;
    const bool bullet = movable && (body.def.bullet || mode == Continuous::on);
    motion_class_[i] = bullet ? MotionClass::bullet : MotionClass::fast;
    if (bullet || !movable) hits_dynamic_ = true;
  }
  return any;
}

/// Lists the bodies that may be fast and those without mass.
void ContinuousCollision::list_candidates(const BodySet& bodies) {
  candidates_.resize(bodies.size());
  std::uint32_t* next = candidates_.data();
  for (std::uint32_t i = 0; i < candidates_.size(); ++i) {
    // |x| + |y| bounds the length and needs no square root; it rejects most bodies. 1/64 is for rounding.
    const Vec2 moved = bodies.pose[i].p - start_[i].p;
    const Real turned = std::abs(bodies.angle[i] - start_angle_[i]) * bodies.bounding_radius[i];
    const bool slow = std::abs(moved.x) + std::abs(moved.y) + turned <= bodies.thickness[i] * (Real{63} / 128);
    *next = i;
    next += static_cast<int>(!slow) | static_cast<int>(bodies.inverse_mass[i].m == 0);
  }
  candidates_.resize(static_cast<std::size_t>(next - candidates_.data()));
}

void ContinuousCollision::list_immovable(const BodySet& bodies) {
  immovable_.clear();
  for (const std::uint32_t i : candidates_) {
    const BodyDetail& body = bodies.detail[i];
    if (!body.inserted || body.def.type == BodyType::dynamic) continue;
    const Path path = this->path(bodies, i);
    for (const Part& part : body.parts) {
      if (part.sensor) continue;
      immovable_.push_back({path.bounds(part.shape, bodies.bounding_radius[i]), &part.shape, path.start,
                            path.moves() ? path.displacement(hull_radius(part.shape)) : Real{0}});
    }
  }
  immovable_bounds_.resize(immovable_.size());
  for (std::uint32_t i = 0; i < immovable_.size(); ++i) immovable_bounds_.set(i, immovable_[i].bounds, {});
}

/// A cheap test that rejects most bodies. The bounds of a path extend from its ends by at most three times the bounding
/// radius; a fourth is for rounding. And a body gets no nearer to a shape than the displacements of both allow.
bool ContinuousCollision::may_meet_immovable(const BodySet& bodies, std::size_t i) {
  constexpr std::size_t most_parts = 64;  // with more, the broad phase is faster
  if (immovable_.size() > most_parts) return true;
  const Vec2 end = bodies.pose[i].p;
  const Real around = 4 * bodies.bounding_radius[i];
  const Aabb swept = grown(Aabb{min(start_[i].p, end), max(start_[i].p, end)}, around);
  const auto count = static_cast<std::uint32_t>(immovable_.size());
  const Real farthest = around + path(bodies, i).displacement(bodies.bounding_radius[i]);
  const auto found = immovable_bounds_.within_reach(swept, {}, {{0, count}});
  return std::any_of(found.begin(), found.end(), [&](std::uint32_t index) {
    const Immovable& part = immovable_[index];
    return height_over(*part.shape, to_local(part.start, start_[i].p)) <= farthest + part.displacement;
  });
}

void ContinuousCollision::find_pairs(const BodySet& bodies, const Passing& passing) {
  proxies_.clear();
  if (!hits_dynamic_) list_immovable(bodies);
  for (const std::uint32_t i : candidates_) {
    const BodyDetail& body = bodies.detail[i];
    const bool fast = motion_class_[i] != MotionClass::slow;
    if (!body.inserted) continue;
    if (!hits_dynamic_ && body.def.type == BodyType::dynamic && !(fast && may_meet_immovable(bodies, i))) continue;
    const Path path = this->path(bodies, i);
    for (std::size_t p = 0; p < body.parts.size(); ++p) {
      if (body.parts[p].sensor) continue;
      proxies_.push_back({path.bounds(body.parts[p].shape, bodies.bounding_radius[i]),
                          {},
                          i,
                          static_cast<std::uint16_t>(p),
                          fast,
                          body.layers_of(body.parts[p])});
    }
  }
  broad_phase_->find_pairs(proxies_, pairs_);
  std::erase_if(pairs_, [&](const Pair& pair) {
    const Proxy& a = proxies_[pair.first];
    const Proxy& b = proxies_[pair.second];
    return passing.joints.connects(a.body, b.body) || passing.contacts.disabled(a, b) ||
           !accepts(passing.filter, bodies, a.body, a.part, b.body, b.part);
  });
}

/// Fixed and kinematic bodies are never clamped, so these stops are final: later ones only shorten a path.
void ContinuousCollision::stop_at_immovable(const BodySet& bodies) {
  for (const Pair& pair : pairs_) {
    const Proxy* other = &proxies_[pair.first];
    const Proxy* moving = &proxies_[pair.second];
    const auto movable = [&](const Proxy* proxy) { return bodies.detail[proxy->body].def.type == BodyType::dynamic; };
    if (movable(other)) std::swap(other, moving);
    if (movable(other) || !movable(moving)) continue;
    Stop stop = find_stop(bodies, *other, *moving);
    if (stop.time >= stops_[moving->body].time) continue;
    stop.with = other->body;
    stops_[moving->body] = stop;
  }
}

/// Stops bullets at the dynamic bodies that they meet, on paths shortened by the stops so far. The other body is
/// clamped too if it is fast; a slow one keeps the rest of its motion, which is less than half its thickness.
void ContinuousCollision::stop_at_each_other(const BodySet& bodies) {
  for (const Pair& pair : pairs_) {
    const Proxy* other = &proxies_[pair.first];
    const Proxy* moving = &proxies_[pair.second];
    if (motion_class_[moving->body] != MotionClass::bullet) std::swap(other, moving);
    if (motion_class_[moving->body] != MotionClass::bullet) continue;
    if (bodies.detail[other->body].def.type != BodyType::dynamic) continue;
    const Stop stop = find_stop(bodies, *other, *moving);
    if (stop.time < stops_[moving->body].time) stops_[moving->body] = stop;
    const bool other_is_fast = motion_class_[other->body] != MotionClass::slow;
    if (other_is_fast && stop.time < stops_[other->body].time) stops_[other->body] = stop;
  }
}

/// A part that touches at the start is left to the solver as long as its core circle stays outside. If the core does
/// not (an impact at a corner may rotate a body into the wall that it hit), only the translation stops: the solver
/// still gets the rotation, so that other corners come into contact.
ContinuousCollision::Stop ContinuousCollision::find_stop(const BodySet& bodies, const Proxy& obstacle,
                                                         const Proxy& moving) const {
  const Path path = this->path(bodies, moving.body);
  const Path other_path = this->path(bodies, obstacle.body);
  const Shape& shape = bodies.detail[moving.body].parts[moving.part].shape;
  const Shape& other_shape = bodies.detail[obstacle.body].parts[obstacle.part].shape;
  // Chains are one-sided: whatever comes from the solid side passes.
  if (other_shape.in_chain()) {
    const Vec2 relative_motion = path.translation - other_path.translation;
    if (dot(relative_motion, other_path.start.q * other_shape.normal(0)) >= 0) return {};
  }

  const Real radius = core_radius(bodies.thickness[moving.body]);
  const Shape core = Shape::circle(radius, shape.centroid());
  const MovingShape other{other_shape, other_path};
  const Real core_time = MovingShape::time_of_impact(other, {core, path}, 0).value_or(Real{1});
  if (core_time == 1) return {};
  const Real overlap = std::min(overlap_left, radius);
  if (const auto time = MovingShape::time_of_impact(other, {shape, path}, overlap)) return {std::min(*time, core_time)};
  return {core_time, true};
}

void ContinuousCollision::clamp_body(BodySet& bodies, std::size_t i) const {
  const Path path = this->path(bodies, i);
  const Stop& stop = stops_[i];
  Pose pose = path.at(stop.keeps_turning ? 1 : stop.time);
  Real angle = path.angle + (stop.keeps_turning ? 1 : stop.time) * path.rotation;
  if (stop.with != none) {
    const Path carrier = this->path(bodies, stop.with);
    if (carrier.moves()) {
      const Pose then = carrier.at(stop.time);
      const Rotation turn = bodies.pose[stop.with].q * then.q.inverse();
      pose = {bodies.pose[stop.with].p + turn * (pose.p - then.p), turn * pose.q};
      angle += (1 - stop.time) * carrier.rotation;
    }
  }
  bodies.pose[i] = pose;
  bodies.angle[i] = angle;
  bodies.remainder[i] = {};
}

}  // namespace impulse::inline IMPULSE_PRECISION
