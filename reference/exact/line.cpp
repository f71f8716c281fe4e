#include "reference/exact/line.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

constexpr std::size_t most_impacts = 20000;  // beyond this they count as accumulating (inelastic collapse)
constexpr double at_once = 1e-12;            // s, within which impacts of one body count as simultaneous

using Particles = std::vector<Line::Particle>;

void move(Particles& particles, double dt) {
  for (Line::Particle& particle : particles) particle.position += particle.speed * dt;
}

// Gap i lies to the left of particle i; the walls do not move.
struct Gap {
  double width = 0;    // m
  double closing = 0;  // m/s
};

Gap gap(const Particles& p, const Line::Walls& walls, std::size_t i) {
  const double left = i == 0 ? walls.left : p[i - 1].position + p[i - 1].half;
  const double right = i == p.size() ? walls.right : p[i].position - p[i].half;
  const double left_speed = i == 0 ? 0 : p[i - 1].speed;
  const double right_speed = i == p.size() ? 0 : p[i].speed;
  return {right - left, left_speed - right_speed};
}

// Momentum is conserved, and the approach speed u is reversed and multiplied by e: each body's speed changes by (1 + e)
// u times the other's share of the total mass. A wall's share is 1.
void collide(Particles& p, std::size_t i, double e, double approach) {
  const double total = (i == 0 || i == p.size()) ? 0 : p[i - 1].mass + p[i].mass;
  if (i > 0) p[i - 1].speed -= (1 + e) * approach * (i == p.size() ? 1 : p[i].mass / total);
  if (i < p.size()) p[i].speed += (1 + e) * approach * (i == 0 ? 1 : p[i - 1].mass / total);
}

}  // namespace

Line::Line(std::vector<Particle> particles, Walls walls, std::vector<double> restitution, double horizon) {
  epochs_.push_back({0, std::move(particles)});
  const std::size_t gaps = epochs_.front().particles.size() + 1;
  std::vector<double> due(gaps);
  while (epochs_.back().time <= horizon) {
    const Particles& now = epochs_.back().particles;
    for (std::size_t i = 0; i < gaps; ++i) {
      const Gap between = gap(now, walls, i);
      due[i] = between.closing > 0 ? std::max(between.width, 0.0) / between.closing : never;
    }
    const auto first = static_cast<std::size_t>(std::min_element(due.begin(), due.end()) - due.begin());
    if (due[first] == never) return;
    const double time = epochs_.back().time + due[first];
    const bool simultaneous = (first > 0 && due[first - 1] - due[first] < at_once) ||
                              (first + 1 < gaps && due[first + 1] - due[first] < at_once);
    if (simultaneous || epochs_.size() > most_impacts) {
      until_ = time;
      return;
    }
    Particles next = now;
    move(next, due[first]);
    collide(next, first, restitution[first], gap(next, walls, first).closing);
    epochs_.push_back({time, std::move(next)});
  }
}

void Line::at(double t, std::span<Particle> out) const {
  const auto after = std::upper_bound(epochs_.begin() + 1, epochs_.end(), t,
                                      [](double time, const Epoch& epoch) { return time < epoch.time; });
  Particles now = std::prev(after)->particles;
  move(now, t - std::prev(after)->time);
  std::copy(now.begin(), now.end(), out.begin());
}

std::size_t Line::impacts(double until) const {
  return static_cast<std::size_t>(
      std::count_if(epochs_.begin() + 1, epochs_.end(), [until](const Epoch& epoch) { return epoch.time <= until; }));
}

namespace {

struct BodiesOnLine {
  std::vector<BodyState> start;
  std::vector<std::size_t> bodies;  // from left to right
  Vec along;
  std::vector<double> positions;  // at the start
  Line line;

  void at(double t, std::span<BodyState> out) const {
    write_states(start, out);
    std::vector<Line::Particle> now(bodies.size());
    line.at(t, now);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      BodyState& state = out[bodies[i]];
      state.position = start[bodies[i]].position + (now[i].position - positions[i]) * along;
      state.velocity = now[i].speed * along;
      state.angle = start[bodies[i]].angle + t * state.angular_velocity;
    }
  }
  double valid_until() const { return line.valid_until(); }
};

// Half the extent along the x axis; nullopt for shapes that would not meet head-on.
std::optional<double> half_extent(const Body& body) {
  if (const Circle* circle = only_shape<Circle>(body); circle != nullptr && circle->center == Vec{})
    return circle->radius;
  const Box* box = only_shape<Box>(body);
  if (box == nullptr || box->center != Vec{} || box->angle != 0 || body.angle != 0) return std::nullopt;
  return box->size.x / 2;
}

// A body or a wall, by its extent.
struct LineObject {
  std::size_t body = 0;
  bool wall = false;
  double low = 0, high = 0;  // m along x
};

std::variant<std::vector<LineObject>, std::string> objects_on_line(const Scene& scene) {
  std::vector<LineObject> row;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (body.type == BodyType::dynamic) {
      const std::optional<double> half = half_extent(body);
      if (!half) return "handles only discs and upright boxes";
      if (gravity_of(scene, body) != Vec{}) return "handles only motion without gravity";
      if (body.position.y != 0 || body.velocity.y != 0 || body.angular_velocity != 0)
        return "handles only motion along y = 0";
      row.push_back({i, false, body.position.x - *half, body.position.x + *half});
      continue;
    }
    if (const HalfSpace* half = only_shape<HalfSpace>(body); half != nullptr && body.type == BodyType::fixed) {
      const Vec n = rotated(half->normal, body.angle);
      if (std::abs(n.y) > geometry_tolerance) return "handles only walls perpendicular to the line";
      LineObject wall{.body = i, .wall = true, .low = -never, .high = never};
      (n.x > 0 ? wall.high : wall.low) = n.x * (half->offset + dot(n, body.position));
      row.push_back(wall);
    } else if (const std::optional<double> extent = half_extent(body); extent && body.type == BodyType::fixed) {
      row.push_back({i, true, body.position.x - *extent, body.position.x + *extent});
    } else {
      return "handles only walls perpendicular to the line";
    }
  }
  std::sort(row.begin(), row.end(),
            [](const LineObject& a, const LineObject& b) { return a.low + a.high < b.low + b.high; });
  return row;
}

Recognised<BodiesOnLine> recognise_line(const Scene& scene) {
  if (const std::string reason = contact_refusal(scene); !reason.empty()) return reason;
  const auto found = objects_on_line(scene);
  if (const std::string* reason = std::get_if<std::string>(&found)) return *reason;
  const auto& row = std::get<std::vector<LineObject>>(found);

  std::vector<Line::Particle> particles;
  std::vector<std::size_t> bodies;
  std::vector<double> positions;
  std::vector<double> restitution;
  Line::Walls walls;
  for (std::size_t k = 0; k < row.size(); ++k) {
    const Body& body = scene.bodies[row[k].body];
    const bool first = k == 0;
    const bool last = k + 1 == row.size();
    if (row[k].wall && !first && !last) return "handles only walls at the ends";
    if (!first && row[k].low < row[k - 1].high - geometry_tolerance) return "handles only bodies that do not overlap";
    // Without a wall there is no impact at that end, so its restitution does not matter.
    if (first && !row[k].wall) restitution.push_back(0);
    if (!first) {
      const Body& before = scene.bodies[row[k - 1].body];
      restitution.push_back(mixed_coefficients(scene, before, body).restitution);
      // Who bounces first is open if one of them is struck.
      if (restitution.back() > 0 && row[k].low <= row[k - 1].high && body.velocity == before.velocity)
        return "handles only bodies that do not touch at the start";
    }
    if (last && !row[k].wall) restitution.push_back(0);
    if (row[k].wall) {
      (first ? walls.left : walls.right) = first ? row[k].high : row[k].low;
      continue;
    }
    bodies.push_back(row[k].body);
    positions.push_back(body.position.x);
    particles.push_back({body.position.x, body.velocity.x, mass_of(body).mass, (row[k].high - row[k].low) / 2});
  }
  if (particles.empty()) return "handles only bodies that move";
  return BodiesOnLine{
      start_of(scene), bodies, {1, 0}, positions, Line(particles, walls, restitution, scene.duration + longest_step)};
}

const Catalog<Engine>::Entry line_entry{closed_form<BodiesOnLine>(
    {.name = "line",
     .about = "Impacts along one line, two bodies at a time: v' = ((m1 - e m2) v1 + (1 + e) m2 v2)/(m1 + m2)",
     .source = "Newton's law of restitution; Galperin, Playing pool with pi (2003)"},
    recognise_line)};

}  // namespace
}  // namespace plumb
