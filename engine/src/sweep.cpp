#include "sweep.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "distance.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// m, by which bodies overlap when they are put back, so that the next step sees them touch.
constexpr Real overlap_left = static_cast<Real>(0.001);
/// m, at which two shapes have met.
constexpr Real met = static_cast<Real>(0.0001);
/// Advances are geometric unless a body spins wildly; what has not met by then is put back early, which is safe.
constexpr int most_advances = 64;

}  // namespace

/// How a body went through a step: straight on, turning evenly.
struct Sweep::Path {
  Pose start;
  Vec2 run;
  Real angle = 0;
  Real turn = 0;

  Pose at(Real t) const { return {start.p + t * run, turn == 0 ? start.q : Rotation(angle + t * turn)}; }
  Aabb bounds(const Shape& shape, Real reach) const {
    const Aabb ends = merged(shape.bounds(at(0)), shape.bounds(at(1)));
    // Between the ends a turning shape may stick out by its reach.
    return turn == 0 ? ends : grown(ends, std::min(std::abs(turn), Real{2}) * reach);
  }
};

void Sweep::remember(const BodySet& bodies) {
  start_ = bodies.pose;
  start_angle_ = bodies.angle;
}

Sweep::Path Sweep::path(const BodySet& bodies, std::size_t i) const {
  return {start_[i], bodies.pose[i].p - start_[i].p, start_angle_[i], bodies.angle[i] - start_angle_[i]};
}

namespace {

/// The share of the step after which a part on its way meets what stands, 1 if it doesn't, by conservative advancement
/// (B. Mirtich 1996): at a distance d along n, nothing can meet before the gap has closed at its highest speed,
///
///     t += d / (-n . run + |turn| reach).
///
/// Ends with the overlap asked for. Nothing if the two touch from the start.
template <class Path>
std::optional<Real> meeting(const Shape& standing, const Pose& pose, const Shape& moving, const Path& path, Real reach,
                            Real overlap) {
  Real t = 0;
  for (int i = 0; i < most_advances; ++i) {
    const Gap gap = distance(standing, pose, moving, path.at(t));
    if (gap.distance == 0) {
      if (t == 0) return std::nullopt;
      return t;
    }
    const Real closing = std::abs(path.turn) * reach - dot(path.run, gap.normal);
    if (closing <= 0) return Real{1};
    const bool here = gap.distance <= met;
    if (!here || overlap > 0) t += (gap.distance + (here ? overlap : 0)) / closing;
    if (here || t >= 1) return std::min(t, Real{1});
  }
  return t;
}

/// A chain lets pass what comes from its solid side.
bool leaves_from_behind(const Shape& shape, Rotation q, Vec2 run) {
  return shape.in_chain() && dot(run, q * shape.normal(0)) >= 0;
}

}  // namespace

void Sweep::hold_back(BodySet& bodies, const JointSet& joints) const {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies.inverse_mass[i].m == 0) continue;
    const Path path = this->path(bodies, i);
    const Real farthest = length(path.run) + std::abs(path.turn) * bodies.reach[i];
    if (farthest <= bodies.detail[i].thickness / 2) continue;
    const Stop stop = first_stop(bodies, joints, i);
    if (stop.after == 1) continue;
    bodies.pose[i].p = path.at(stop.after).p;
    bodies.remainder[i] = {};
    if (stop.turns_on) continue;
    bodies.pose[i].q = path.at(stop.after).q;
    bodies.angle[i] = path.angle + stop.after * path.turn;
  }
}

Sweep::Stop Sweep::first_stop(const BodySet& bodies, const JointSet& joints, std::size_t i) const {
  const BodyDetail& body = bodies.detail[i];
  const Path path = this->path(bodies, i);
  Stop first;
  for (std::size_t j = 0; j < bodies.size(); ++j) {
    const BodyDetail& other = bodies.detail[j];
    if (j == i || !other.inserted || (other.def.layers & body.def.layers) == 0) continue;
    if (other.def.type == BodyType::dynamic && !body.def.bullet) continue;
    if (joints.ties(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j))) continue;
    const Pose& pose = bodies.pose[j];
    for (const Part& part : body.parts) {
      const Aabb bounds = path.bounds(part.shape, bodies.reach[i]);
      for (const Part& standing : other.parts) {
        if (!overlap(bounds, standing.shape.bounds(pose))) continue;
        if (leaves_from_behind(standing.shape, pose.q, path.run)) continue;
        const Stop stop = stop_at(standing.shape, pose, part.shape, body.thickness, path, bodies.reach[i]);
        if (stop.after < first.after) first = stop;
      }
    }
  }
  return first;
}

/// A part that touches from the start is the solver's, as long as its middle stays outside: an impact on a corner may
/// turn a body into the wall that it hit. Its turn is left to it, so that other corners come to touch.
Sweep::Stop Sweep::stop_at(const Shape& standing, const Pose& pose, const Shape& moving, Real thickness,
                           const Path& path, Real reach) {
  if (const auto t = meeting(standing, pose, moving, path, reach, overlap_left)) return {*t, false};
  const Shape middle = Shape::circle(std::max(thickness / 4, met), moving.centroid());
  return {meeting(standing, pose, middle, path, reach, 0).value_or(Real{1}), true};
}

}  // namespace impulse::inline IMPULSE_PRECISION
