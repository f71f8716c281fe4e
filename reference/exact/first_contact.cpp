#include "reference/exact/first_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

void append(const Circle& circle, std::vector<Corner>& corners) { corners.push_back({circle.center, circle.radius}); }

void append(const Box& box, std::vector<Corner>& corners) {
  for (const Vec sign : {Vec{1, 1}, Vec{-1, 1}, Vec{-1, -1}, Vec{1, -1}}) {
    const Vec corner{sign.x * box.size.x / 2, sign.y * box.size.y / 2};
    corners.push_back({box.center + turned(corner, box.angle), 0});
  }
}

void append(const Polygon& polygon, std::vector<Corner>& corners) {
  for (const Vec vertex : polygon.vertices) corners.push_back({vertex, 0});
}

void append(const Capsule& capsule, std::vector<Corner>& corners) {
  corners.push_back({capsule.from, capsule.radius});
  corners.push_back({capsule.to, capsule.radius});
}

void append(const Segment& segment, std::vector<Corner>& corners) {
  corners.push_back({segment.from, 0});
  corners.push_back({segment.to, 0});
}

void append(const HalfSpace&, std::vector<Corner>&) {}  // has no corner

// The longest time in which a corner cannot have come down: its clearance is d + d' s + d'' s^2/2 with
// |d''| <= bend = |g.n| + w^2 R, so it stays above d + d' s - bend s^2/2 up to that parabola's root.
double safe_step(double d, double rate, double bend) {
  if (bend == 0) return rate < 0 ? d / -rate : std::numeric_limits<double>::infinity();
  const double root = std::sqrt(std::max(rate * rate + 2 * bend * d, 0.0));
  // Falling: the form that does not cancel.
  return rate < 0 ? 2 * d / (root - rate) : (rate + root) / bend;
}

}  // namespace

std::vector<Corner> corners_of(const Body& body) {
  std::vector<Corner> corners;
  for (const Shape& shape : body.shapes) {
    std::visit([&corners](const auto& geometry) { append(geometry, corners); }, shape.geometry);
  }
  const Vec center = mass_of(body).center;
  for (Corner& corner : corners) corner.offset = corner.offset - center;
  return corners;
}

double clearance(const Corner& corner, const BodyState& state, const Floor& floor) {
  const Vec point = state.position + turned(corner.offset, state.angle);
  return dot(point, floor.normal) - floor.offset - corner.radius;
}

// Advance by what is safe for every corner, again and again: no root is ever jumped over, and near one the steps become
// Newton's from above, so they end at it quadratically.
std::optional<Contact> first_contact(const BodyState& start, Vec gravity, const std::vector<Corner>& corners,
                                     const Floor& floor, double horizon) {
  double time = 0;
  while (time <= horizon) {
    const BodyState now = thrown(start, gravity, time);
    double step = std::numeric_limits<double>::infinity();
    std::size_t next = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec arm = turned(corners[i].offset, now.angle);
      const double rate = dot(now.velocity + now.angular_velocity * left_of(arm), floor.normal);
      const double bend = std::abs(dot(gravity, floor.normal)) +
                          now.angular_velocity * now.angular_velocity * length(corners[i].offset);
      const double safe = safe_step(clearance(corners[i], now, floor), rate, bend);
      if (safe < step) {
        step = safe;
        next = i;
      }
    }
    if (step <= 0 || time + step == time) return Contact{time, next};
    time += step;
  }
  return std::nullopt;
}

}  // namespace plumb
