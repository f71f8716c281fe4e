#include "scenarios/scene/mass.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace plumb {
namespace {

// Area, centre and second moment about that centre: the mass of density 1.
struct Area {
  double area = 0;
  Vec center;
  double second_moment = 0;
};

Area area_of(const Circle& circle) {
  const double area = std::numbers::pi * circle.radius * circle.radius;
  return {area, circle.center, area * circle.radius * circle.radius / 2};
}

Area area_of(const Box& box) {
  const double area = box.size.x * box.size.y;
  return {area, box.center, area * (box.size.x * box.size.x + box.size.y * box.size.y) / 12};
}

// Green's theorem turns the integrals over the area into sums over edges p -> q, with c = p x q:
//   A = sum c / 2,   S = sum c (p + q) / 6,   J = sum c (p.p + p.q + q.q) / 12   (J about the origin).
// The first vertex is taken as origin, so that a polygon far from its body's frame loses no digits.
Area area_of(const Polygon& polygon) {
  const std::vector<Vec>& v = polygon.vertices;
  if (v.size() < 3) return {};
  double area = 0;
  double moment = 0;
  Vec first;
  for (std::size_t i = 1; i + 1 < v.size(); ++i) {
    const Vec p{v[i].x - v[0].x, v[i].y - v[0].y};
    const Vec q{v[i + 1].x - v[0].x, v[i + 1].y - v[0].y};
    const double c = p.x * q.y - p.y * q.x;
    area += c / 2;
    first.x += c * (p.x + q.x) / 6;
    first.y += c * (p.y + q.y) / 6;
    moment += c * (p.x * p.x + p.y * p.y + p.x * q.x + p.y * q.y + q.x * q.x + q.y * q.y) / 12;
  }
  if (area == 0) return {};
  const Vec center{first.x / area, first.y / area};
  // Clockwise vertices turn every sign; the ratio above is the same either way.
  moment = std::abs(moment) - std::abs(area) * (center.x * center.x + center.y * center.y);
  return {std::abs(area), {v[0].x + center.x, v[0].y + center.y}, moment};
}

// A rectangle L x 2r and two half discs. A half disc's centre lies c = 4 r/(3 pi) from its flat side; moved from there
// to the capsule's middle, L/2 + c away, the two together have A_d (r^2/2 + L^2/4 + L c), A_d the area of the whole
// disc.
Area area_of(const Capsule& capsule) {
  const double length = std::hypot(capsule.to.x - capsule.from.x, capsule.to.y - capsule.from.y);
  const double r = capsule.radius;
  const double rectangle = length * 2 * r;
  const double disc = std::numbers::pi * r * r;
  const double c = 4 * r / (3 * std::numbers::pi);
  return {rectangle + disc,
          {(capsule.from.x + capsule.to.x) / 2, (capsule.from.y + capsule.to.y) / 2},
          rectangle * (length * length + 4 * r * r) / 12 + disc * (r * r / 2 + length * length / 4 + length * c)};
}

Area area_of(const Segment&) { return {}; }
Area area_of(const HalfSpace&) { return {}; }

}  // namespace

Mass mass_of(const Body& body) {
  if (body.type != BodyType::dynamic) return {};
  Mass total;
  for (const Shape& shape : body.shapes) {
    const Area part = std::visit([](const auto& geometry) { return area_of(geometry); }, shape.geometry);
    const double mass = shape.surface.density * part.area;
    if (mass == 0) continue;
    // Each part joins by its own inertia and, by the parallel-axis theorem, m1 m2/(m1 + m2) d^2 for its distance d from
    // what is there already: sums of positive terms only, nothing cancels.
    const Vec apart{part.center.x - total.center.x, part.center.y - total.center.y};
    const double share = mass / (total.mass + mass);
    total.inertia +=
        shape.surface.density * part.second_moment + total.mass * share * (apart.x * apart.x + apart.y * apart.y);
    total.center = {total.center.x + share * apart.x, total.center.y + share * apart.y};
    total.mass += mass;
  }
  if (body.fixed_rotation) total.inertia = 0;
  return total;
}

}  // namespace plumb
