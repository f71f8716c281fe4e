#include "reference/exact/flight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/shapes.h"

namespace plumb {

BodyState free_flight(const BodyState& start, Vec acceleration, double t) {
  return {.position = start.position + t * start.velocity + (t * t / 2) * acceleration,
          .angle = start.angle + t * start.angular_velocity,
          .velocity = start.velocity + t * acceleration,
          .angular_velocity = start.angular_velocity};
}

Ballistic::Ballistic(std::vector<BodyState> start, std::vector<Vec> acceleration)
    : start_(std::move(start)), acceleration_(std::move(acceleration)) {}

void Ballistic::at(double t, std::span<BodyState> out) const {
  for (std::size_t i = 0; i < start_.size(); ++i) out[i] = free_flight(start_[i], acceleration_[i], t);
}

namespace {

bool may_meet(const Body& a, const Body& b) {
  const bool moves = a.type == BodyType::dynamic || b.type == BodyType::dynamic;
  return moves && (a.layers & b.layers) != 0 && !a.shapes.empty() && !b.shapes.empty();
}

Recognised<Ballistic> recognise_ballistic(const Scene& scene) {
  if (const std::string reason = textbook_refusal(scene); !reason.empty()) return reason;
  std::vector<Vec> acceleration;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (may_meet(scene.bodies[i], scene.bodies[j])) return "handles only bodies that share no layer with each other";
    }
    acceleration.push_back(gravity_of(scene, scene.bodies[i]));
  }
  return Ballistic(start_of(scene), std::move(acceleration));
}

const Catalog<Engine>::Entry ballistic_entry{closed_form<Ballistic>(
    {.name = "ballistic",
     .about = "Free fall of bodies that touch nothing: r = r0 + v0 t + g t^2/2, angle = a0 + w t",
     .source = "Galileo, Discorsi (1638), fourth day; Goldstein, Classical Mechanics, ch. 1"},
    recognise_ballistic)};

}  // namespace

namespace {

// The longest time, s, in which a corner surely stays above the floor. Its clearance d(s) has |d''| <= bend = |g.n| +
// w^2 R, so it stays above the parabola d + d' s - bend s^2/2 up to the root of that.
double safe_step(double d, double rate, double bend) {
  if (bend == 0) return rate < 0 ? d / -rate : std::numeric_limits<double>::infinity();
  const double root = std::sqrt(std::max(rate * rate + 2 * bend * d, 0.0));
  // If falling, the form without cancellation.
  return rate < 0 ? 2 * d / (root - rate) : (rate + root) / bend;
}

}  // namespace

std::vector<Corner> corners_of(const Body& body) {
  std::vector<Corner> corners;
  const Vec center = mass_of(body).center;
  for (const Shape& shape : body.shapes) {
    const Outline outline = outline_of(shape.geometry, center);
    for (const Vec point : outline.points) corners.push_back({point, outline.radius});
  }
  return corners;
}

double clearance(const Corner& corner, const BodyState& state, const Floor& floor) {
  const Vec point = state.position + rotated(corner.offset, state.angle);
  return dot(point, floor.normal) - floor.offset - corner.radius;
}

// Repeatedly advances by a time that is safe for every corner. No contact is ever skipped, and near one the steps
// become Newton's method from above, which converges quadratically.
std::optional<FloorContact> first_contact(const BodyState& start, Vec gravity, const std::vector<Corner>& corners,
                                          const Floor& floor, double horizon) {
  double time = 0;
  while (time <= horizon) {
    const BodyState now = free_flight(start, gravity, time);
    double step = std::numeric_limits<double>::infinity();
    std::size_t next = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec arm = rotated(corners[i].offset, now.angle);
      const double rate = dot(now.velocity + now.angular_velocity * perpendicular(arm), floor.normal);
      const double bend = std::abs(dot(gravity, floor.normal)) +
                          now.angular_velocity * now.angular_velocity * length(corners[i].offset);
      const double safe = safe_step(clearance(corners[i], now, floor), rate, bend);
      if (safe < step) {
        step = safe;
        next = i;
      }
    }
    if (step <= 0 || time + step == time) return FloorContact{time, next};
    time += step;
  }
  return std::nullopt;
}

}  // namespace plumb
