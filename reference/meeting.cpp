#include "reference/meeting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "reference/exact/recognise.h"
#include "reference/scene_facts.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

constexpr double clear = 1e-3;         // m, left between two that never meet: far beyond round-off
constexpr std::size_t most = 1 << 10;  // bodies of which every pair is looked at, in some ms

struct Extent {
  double operator()(const Circle& circle) const { return length(circle.center) + circle.radius; }
  double operator()(const Box& box) const { return length(box.center) + length(box.size) / 2; }
  double operator()(const Polygon& polygon) const {
    return std::accumulate(polygon.vertices.begin(), polygon.vertices.end(), 0.0,
                           [](double far, Vec vertex) { return std::max(far, length(vertex)); });
  }
  double operator()(const Capsule& capsule) const {
    return std::max(length(capsule.from), length(capsule.to)) + capsule.radius;
  }
  double operator()(const Segment& segment) const { return std::max(length(segment.from), length(segment.to)); }
  double operator()(const HalfSpace&) const { return std::numeric_limits<double>::infinity(); }
};

// A body as the disc about its centre of mass that holds it however it turns, on a parabola.
struct Flight {
  const Body* body;
  BodyState start;
  Vec acceleration;
  double radius;  // m; infinite for a half-space
};

bool collide(const Body& a, const Body& b) {
  return (a.layers & b.layers) != 0 && (a.type == BodyType::dynamic || b.type == BodyType::dynamic);
}

bool tied(const Scene& scene, std::size_t a, std::size_t b) {
  return std::any_of(scene.joints.begin(), scene.joints.end(), [&](const Joint& joint) {
    return std::visit([&](const auto& tie) { return (tie.a == a && tie.b == b) || (tie.a == b && tie.b == a); }, joint);
  });
}

std::vector<std::pair<std::size_t, std::size_t>> colliding_pairs(const Scene& scene) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t a = 0; a < scene.bodies.size(); ++a) {
    if (scene.bodies[a].shapes.empty()) continue;
    for (std::size_t b = a + 1; b < scene.bodies.size(); ++b) {
      if (scene.bodies[b].shapes.empty() || !collide(scene.bodies[a], scene.bodies[b]) || tied(scene, a, b)) continue;
      pairs.emplace_back(a, b);
    }
  }
  return pairs;
}

Flight flight_of(const Scene& scene, std::size_t i) {
  const Body& body = scene.bodies[i];
  const Body around = centered(body);
  Flight flight{&body, start_of(body), gravity_of(scene, body), 0};
  for (const Shape& shape : around.shapes) {
    flight.radius = std::max(flight.radius, std::visit(Extent{}, shape.geometry));
  }
  for (const Force& force : scene.forces) {
    const auto* constant = std::get_if<Constant>(&force);
    if (constant != nullptr && constant->body == i) {
      flight.acceleration = flight.acceleration + (1 / mass_of(body).mass) * constant->force;
    }
  }
  return flight;
}

// Least and largest of x + v t + a t^2/2 over 0 ... T.
std::pair<double, double> range(double x, double v, double a, double duration) {
  const auto at = [=](double t) { return x + t * (v + a * t / 2); };
  auto [low, high] = std::minmax({at(0), at(duration)});
  const double vertex = a == 0 ? -1 : -v / a;
  if (vertex > 0 && vertex < duration) {
    low = std::min(low, at(vertex));
    high = std::max(high, at(vertex));
  }
  return {low, high};
}

double distance_to(std::pair<double, double> range) { return std::max({range.first, -range.second, 0.0}); }

// m, that two points at least keep between them; straight on it is exact, on a parabola that of the box around it.
double least_distance(const Flight& a, const Flight& b, double duration) {
  const Vec r = b.start.position - a.start.position;
  const Vec v = b.start.velocity - a.start.velocity;
  const Vec acceleration = b.acceleration - a.acceleration;
  if (acceleration == Vec{}) {
    const double speed = dot(v, v);
    const double t = speed > 0 ? std::clamp(-dot(r, v) / speed, 0.0, duration) : 0;
    return length(r + t * v);
  }
  return std::hypot(distance_to(range(r.x, v.x, acceleration.x, duration)),
                    distance_to(range(r.y, v.y, acceleration.y, duration)));
}

bool stays_above(const Flight& flight, const Body& ground, double duration) {
  return std::all_of(ground.shapes.begin(), ground.shapes.end(), [&](const Shape& shape) {
    const auto* half = std::get_if<HalfSpace>(&shape.geometry);
    if (half == nullptr || ground.type != BodyType::fixed) return false;
    const Vec n = turned(half->normal, ground.angle);
    const double height = dot(n, flight.start.position - ground.position) - half->offset;
    return range(height, dot(n, flight.start.velocity), dot(n, flight.acceleration), duration).first >
           flight.radius + clear;
  });
}

bool never_meet(const Scene& scene, const Flight& a, const Flight& b) {
  if (std::isinf(a.radius)) return !std::isinf(b.radius) && stays_above(b, *a.body, scene.duration);
  if (std::isinf(b.radius)) return stays_above(a, *b.body, scene.duration);
  return least_distance(a, b, scene.duration) > a.radius + b.radius + clear;
}

// Nothing but gravity and constant forces acts.
bool flies(const Scene& scene) {
  const bool constant = std::all_of(scene.forces.begin(), scene.forces.end(),
                                    [](const Force& force) { return std::holds_alternative<Constant>(force); });
  return constant && scene.joints.empty() &&
         std::all_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const Body& body) { return body.linear_damping == 0 && body.angular_damping == 0; });
}

}  // namespace

std::string why_none_meet(const Scene& scene) {
  if (scene.bodies.size() > most) return "";
  const auto pairs = colliding_pairs(scene);
  if (pairs.empty()) return "no two bodies have shapes that share a layer, but those that a joint ties";
  if (!flies(scene)) return "";
  std::vector<Flight> flights;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) flights.push_back(flight_of(scene, i));
  const bool none = std::all_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
    return never_meet(scene, flights[pair.first], flights[pair.second]);
  });
  return none ? "all fly freely, and no two parabolas come within reach of each other while the scene lasts" : "";
}

}  // namespace plumb
