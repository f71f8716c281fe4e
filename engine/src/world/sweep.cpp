#include "world/sweep.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "core/method_list.h"
#include "shapes/distance.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// m, by which bodies overlap when they are put back, so that the next step sees them touch; thin ones by less.
constexpr Real overlap_left = static_cast<Real>(0.001);
/// m, at which two shapes have met.
constexpr Real met = static_cast<Real>(0.0001);
/// Advances are geometric unless a body spins wildly; what has not met by then is put back early, which is safe.
constexpr int most_advances = 64;

/// Half of a body's half thickness: its middle, which keeps to its side of whatever the body touches.
Real middle_radius(Real thickness) { return std::max(thickness / 4, met); }

/// m, of the farthest point that turning moves: a rounded shape is a core and a disc, and the disc looks the same
/// turned.
Real core_reach(const Shape& shape) {
  Real farthest = 0;
  for (int i = 0; i < shape.count(); ++i) farthest = std::max(farthest, length(shape.vertex(i)));
  return farthest;
}

/// m, from a point to the farthest of the faces that it is before: no part of the shape is nearer.
Real height_over(const Shape& shape, Vec2 local) {
  if (shape.type() == ShapeType::half_space) return dot(shape.normal(0), local) - shape.offset();
  Real highest = 0;
  for (int i = 0; i < shape.count(); ++i) {
    highest = std::max(highest, dot(shape.normal(i), local - shape.vertex(i)) - shape.radius());
  }
  return highest;
}

}  // namespace

/// How a body went through a step: straight on, turning evenly, as far as its stop.
struct Sweep::Path {
  Pose start;
  Vec2 run;
  Real angle = 0;
  Real turn = 0;
  Stop stop;

  Pose at(Real t) const {
    const Real moved = std::min(t, stop.after);
    const Real turned = stop.turns_on ? t : moved;
    return {start.p + moved * run, turn == 0 ? start.q : Rotation(angle + turned * turn)};
  }
  Aabb bounds(const Shape& shape, Real reach) const {
    const Aabb ends = merged(shape.bounds(at(0)), shape.bounds(at(1)));
    // Between the ends a turning shape may stick out by its reach.
    return turn == 0 ? ends : grown(ends, std::min(std::abs(turn), Real{2}) * reach);
  }
  bool moves() const { return !(run == Vec2{} && turn == 0); }
  /// m, no point comes farther that is so near to the middle.
  Real way(Real reach) const { return length(run) + std::abs(turn) * reach; }
};

struct Sweep::Mover {
  const Shape& shape;
  const Path& path;
  Real core = core_reach(shape);

  /// m a step, at which no point of it goes faster along n.
  Real speed_along(Vec2 n) const {
    const Real straight = dot(path.run, n);
    return (path.stop.after < 1 ? std::max(straight, Real{0}) : straight) + std::abs(path.turn) * core;
  }

  /// The share of the step after which the two meet, 1 if they don't, by conservative advancement (B. Mirtich 1996): at
  /// a distance d along n, nothing can meet before the gap has closed at its highest speed,
  ///
  ///     t += d / (speed of a along n + speed of b along -n).
  ///
  /// Ends at the depth asked for, just short of touching if that is 0. Nothing if the two touch from the start.
  static std::optional<Real> meeting(const Mover& a, const Mover& b, Real depth) {
    Real t = 0;
    for (int i = 0; i < most_advances; ++i) {
      const Gap gap = distance(a.shape, a.path.at(t), b.shape, b.path.at(t));
      if (gap.distance == 0) {
        if (t == 0) return std::nullopt;
        return t;
      }
      const Real closing = a.speed_along(gap.normal) + b.speed_along(-gap.normal);
      if (closing <= 0) return Real{1};
      if (gap.distance <= met) {
        return depth > 0 ? std::min(t + (gap.distance + depth) / closing, Real{1}) : t;
      }
      t += (gap.distance - met / 2) / closing;  // not all of it: rounding must not bring them past touching
      if (t >= 1) return Real{1};
    }
    return t;
  }
};

Sweep::Sweep() : broad_phase_(MethodList<BroadPhase>::make("auto")) {}

void Sweep::remember(const BodySet& bodies) {
  start_ = bodies.pose;
  start_angle_ = bodies.angle;
}

Sweep::Path Sweep::path(const BodySet& bodies, std::size_t i) const {
  return {start_[i], bodies.pose[i].p - start_[i].p, start_angle_[i], bodies.angle[i] - start_angle_[i], stops_[i]};
}

void Sweep::hold_back(BodySet& bodies, const JointSet& joints, Continuous mode) {
  if (!find_fast(bodies, mode)) return;
  if (meets_movable_) {
    concerned_.resize(bodies.size());
    std::iota(concerned_.begin(), concerned_.end(), 0U);
  }
  stops_.resize(bodies.size());
  for (const std::uint32_t i : concerned_) stops_[i] = {};
  find_pairs(bodies);
  stop_at_immovable(bodies, joints);
  if (meets_movable_) stop_at_each_other(bodies, joints);
  for (const std::uint32_t i : concerned_) {
    if (stops_[i].after < 1) put_back(bodies, i);
  }
}

bool Sweep::find_fast(const BodySet& bodies, Continuous mode) {
  list_concerned(bodies);
  pace_.assign(bodies.size(), Pace::slow);
  meets_movable_ = false;
  bool any = false;
  for (const std::uint32_t i : concerned_) {
    const Real way = length(bodies.pose[i].p - start_[i].p);
    const Real farthest = way + std::abs(bodies.angle[i] - start_angle_[i]) * bodies.reach[i];
    if (farthest <= bodies.thickness[i] / 2) continue;
    const BodyDetail& body = bodies.detail[i];
    any = true;
    const bool movable = body.def.type == BodyType::dynamic;
    const bool bullet = movable && (body.def.bullet || mode == Continuous::on);
    pace_[i] = bullet ? Pace::bullet : Pace::fast;
    if (bullet || !movable) meets_movable_ = true;
  }
  return any;
}

/// What may be fast or is not pushed.
void Sweep::list_concerned(const BodySet& bodies) {
  concerned_.resize(bodies.size());
  std::uint32_t* next = concerned_.data();
  for (std::uint32_t i = 0; i < concerned_.size(); ++i) {
    // In two legs a way is no shorter; most are too short even so. 1/64 is for rounding.
    const Vec2 run = bodies.pose[i].p - start_[i].p;
    const Real turned = std::abs(bodies.angle[i] - start_angle_[i]) * bodies.reach[i];
    const bool slow = std::abs(run.x) + std::abs(run.y) + turned <= bodies.thickness[i] * (Real{63} / 128);
    *next = i;
    next += static_cast<int>(!slow) | static_cast<int>(bodies.inverse_mass[i].m == 0);
  }
  concerned_.resize(static_cast<std::size_t>(next - concerned_.data()));
}

void Sweep::find_immovable(const BodySet& bodies) {
  immovable_.clear();
  for (const std::uint32_t i : concerned_) {
    const BodyDetail& body = bodies.detail[i];
    if (!body.inserted || body.def.type == BodyType::dynamic) continue;
    const Path path = this->path(bodies, i);
    for (const Part& part : body.parts) {
      immovable_.push_back({path.bounds(part.shape, bodies.reach[i]), &part.shape, path.start,
                            path.moves() ? path.way(core_reach(part.shape)) : Real{0}});
    }
  }
  immovable_bounds_.resize(immovable_.size());
  for (std::uint32_t i = 0; i < immovable_.size(); ++i) immovable_bounds_.set(i, immovable_[i].bounds, {});
}

/// No bounds of a path stick out of its ends by more than three times the body's reach; a fourth is for rounding. Nor
/// does the body come nearer to a shape than the ways of both allow.
bool Sweep::may_meet_immovable(const BodySet& bodies, std::size_t i) {
  constexpr std::size_t handful = 64;
  if (immovable_.size() > handful) return true;
  const Vec2 end = bodies.pose[i].p;
  const Real around = 4 * bodies.reach[i];
  const Aabb way = grown(Aabb{min(start_[i].p, end), max(start_[i].p, end)}, around);
  const auto count = static_cast<std::uint32_t>(immovable_.size());
  const Real farthest = around + path(bodies, i).way(bodies.reach[i]);
  const auto candidates = immovable_bounds_.within_reach(way, {}, {{0, count}});
  return std::any_of(candidates.begin(), candidates.end(), [&](std::uint32_t candidate) {
    const Immovable& part = immovable_[candidate];
    return height_over(*part.shape, to_local(part.start, start_[i].p)) <= farthest + part.way;
  });
}

void Sweep::find_pairs(const BodySet& bodies) {
  proxies_.clear();
  if (!meets_movable_) find_immovable(bodies);
  for (const std::uint32_t i : concerned_) {
    const BodyDetail& body = bodies.detail[i];
    const bool fast = pace_[i] != Pace::slow;
    if (!body.inserted) continue;
    if (!meets_movable_ && body.def.type == BodyType::dynamic && !(fast && may_meet_immovable(bodies, i))) continue;
    const Path path = this->path(bodies, i);
    for (std::size_t p = 0; p < body.parts.size(); ++p) {
      proxies_.push_back({path.bounds(body.parts[p].shape, bodies.reach[i]),
                          {},
                          i,
                          static_cast<std::uint16_t>(p),
                          fast,
                          body.def.layers});
    }
  }
  broad_phase_->find_pairs(proxies_, pairs_);
}

/// Fixed and kinematic bodies are not put back, so these stops are final: later ones only shorten a way.
void Sweep::stop_at_immovable(const BodySet& bodies, const JointSet& joints) {
  for (const Pair& pair : pairs_) {
    const Proxy* other = &proxies_[pair.first];
    const Proxy* moving = &proxies_[pair.second];
    const auto movable = [&](const Proxy* proxy) { return bodies.detail[proxy->body].def.type == BodyType::dynamic; };
    if (movable(other)) std::swap(other, moving);
    if (movable(other) || !movable(moving) || joints.ties(other->body, moving->body)) continue;
    Stop stop = meeting_of(bodies, *other, *moving);
    if (stop.after >= stops_[moving->body].after) continue;
    stop.with = other->body;
    stops_[moving->body] = stop;
  }
}

/// A bullet and what it meets on its way as far as that goes now; the other one is put back as well if it is fast, too:
/// a slow one goes on by less than half its thickness.
void Sweep::stop_at_each_other(const BodySet& bodies, const JointSet& joints) {
  for (const Pair& pair : pairs_) {
    const Proxy* other = &proxies_[pair.first];
    const Proxy* moving = &proxies_[pair.second];
    if (pace_[moving->body] != Pace::bullet) std::swap(other, moving);
    if (pace_[moving->body] != Pace::bullet || bodies.detail[other->body].def.type != BodyType::dynamic) continue;
    if (joints.ties(other->body, moving->body)) continue;
    const Stop stop = meeting_of(bodies, *other, *moving);
    if (stop.after < stops_[moving->body].after) stops_[moving->body] = stop;
    if (pace_[other->body] != Pace::slow && stop.after < stops_[other->body].after) stops_[other->body] = stop;
  }
}

/// A part that touches from the start is the solver's, as long as its middle stays outside: an impact on a corner may
/// turn a body into the wall that it hit. Its turn is left to it, so that other corners come to touch.
Sweep::Stop Sweep::meeting_of(const BodySet& bodies, const Proxy& met_proxy, const Proxy& moving_proxy) const {
  const Path path = this->path(bodies, moving_proxy.body);
  const Path other_path = this->path(bodies, met_proxy.body);
  const Shape& shape = bodies.detail[moving_proxy.body].parts[moving_proxy.part].shape;
  const Shape& other_shape = bodies.detail[met_proxy.body].parts[met_proxy.part].shape;
  // A chain lets pass what comes from its solid side.
  if (other_shape.in_chain() && dot(path.run - other_path.run, other_path.start.q * other_shape.normal(0)) >= 0)
    return {};

  const Real thickness = bodies.thickness[moving_proxy.body];
  const Shape middle_shape = Shape::circle(middle_radius(thickness), shape.centroid());
  const Mover other{other_shape, other_path};
  const Real middle_after = Mover::meeting(other, {middle_shape, path}, 0).value_or(Real{1});
  if (middle_after == 1) return {};
  const Real overlap = std::min(overlap_left, middle_radius(thickness));
  if (const auto after = Mover::meeting(other, {shape, path}, overlap)) return {std::min(*after, middle_after)};
  return {middle_after, true};
}

void Sweep::put_back(BodySet& bodies, std::size_t i) const {
  const Path path = this->path(bodies, i);
  const Stop& stop = stops_[i];
  Pose pose = path.at(stop.turns_on ? 1 : stop.after);
  Real angle = path.angle + (stop.turns_on ? 1 : stop.after) * path.turn;
  if (stop.with != none) {
    const Path carrier = this->path(bodies, stop.with);
    if (carrier.moves()) {
      const Pose then = carrier.at(stop.after);
      const Rotation turn = bodies.pose[stop.with].q * then.q.inverse();
      pose = {bodies.pose[stop.with].p + turn * (pose.p - then.p), turn * pose.q};
      angle += (1 - stop.after) * carrier.turn;
    }
  }
  bodies.pose[i] = pose;
  bodies.angle[i] = angle;
  bodies.remainder[i] = {};
}

}  // namespace impulse::inline IMPULSE_PRECISION
