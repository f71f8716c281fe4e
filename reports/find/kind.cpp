#include "reports/find/kind.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "reports/judge/overlap.h"
#include "reports/run/catalog_case.h"
#include "reports/system/hash.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

// To that many digits after the point.
double rounded(double value, double scale) { return std::round(value * scale) / scale; }

// m, from the origin of the body's frame to its farthest point; half-spaces do not count.
double reach_of(const Body& body) {
  double reach = 0;
  for (const Shape& shape : body.shapes) {
    const Outline outline = outline_of(shape.geometry, {});
    for (const Vec point : outline.points) reach = std::max(reach, std::sqrt(dot(point, point)) + outline.radius);
  }
  return reach;
}

}  // namespace

double Draw::between(double low, double high) {
  return std::clamp(rounded(random_.between(low, high), 1e4), low, high);
}

double Draw::over_magnitudes(double low, double high) {
  int doublings = 1;
  while (std::ldexp(low, doublings) < high) ++doublings;
  const double value = std::ldexp(low, whole(0, doublings - 1)) * random_.between(1, 2);
  double scale = 1e3;
  while (value * scale < 1e3) scale *= 10;
  while (value * scale > 1e4) scale /= 10;
  return std::clamp(rounded(value, scale), low, high);
}

int Draw::whole(int low, int high) {
  return low + static_cast<int>(random_.next() % static_cast<std::uint64_t>(high - low + 1));
}

int Draw::count(int low, int high) { return static_cast<int>(std::floor(over_magnitudes(low, high + 0.9))); }

Vec unit_at(double turn) {
  const double quarters = 4 * (turn - std::floor(turn));
  const double quarter = std::floor(quarters);
  const double t = quarters - quarter;
  const Vec v{(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
  if (quarter == 1) return {-v.y, v.x};
  if (quarter == 2) return {-v.x, -v.y};
  return quarter == 3 ? Vec{v.y, -v.x} : v;
}

Vec Draw::direction() { return unit_at(random_.between(0, 1)); }

Surface Draw::surface() {
  Surface of;
  of.static_friction = chance(0.2) ? 0 : chance(0.15) ? 1 : between(0.05, 1);
  of.dynamic_friction = two_frictions_ ? rounded(of.static_friction * between(0.3, 1), 1e4) : of.static_friction;
  of.restitution = chance(0.45) ? 0 : chance(0.15) ? 1 : between(0.1, 0.95);
  of.density = over_magnitudes(0.5, 8);
  return of;
}

Geometry Draw::geometry(double size) {
  const double slender = chance(0.5) ? 1 : between(0.2, 1);
  switch (whole(0, 3)) {
    case 0:
      return Circle{.radius = size};
    case 1:
      return Box{.size = {rounded(1.4 * size, 1e5), rounded(1.4 * size * slender, 1e5)}};
    case 2: {
      const double radius = rounded(size * std::min(slender, 0.7), 1e5);
      return Capsule{.from = {-(size - radius), 0}, .to = {size - radius, 0}, .radius = radius};
    }
    default: {
      const int corners = whole(3, 8);
      const double first = random_.between(0, 1);
      Polygon polygon;
      for (int i = 0; i < corners; ++i) {
        const Vec at = unit_at(first + (i + random_.between(-0.15, 0.15)) / corners);
        polygon.vertices.push_back({rounded(size * at.x, 1e5), rounded(size * at.y, 1e5)});
      }
      return polygon;
    }
  }
}

Body Draw::body(std::string name, Vec position, double size) {
  Body made{.name = std::move(name), .position = position};
  made.shapes.push_back({.geometry = geometry(size), .surface = surface()});
  made.angle = chance(0.25) ? 0 : between(-3, 3);
  return made;
}

Vec Draw::gravity() {
  if (chance(0.1)) return {};
  const double strength = chance(0.8) ? standard_gravity : between(1, 20);
  return chance(0.85) ? Vec{0, -strength} : Vec{between(-0.4, 0.4) * strength, -strength};
}

Path Draw::path() {
  const double amplitude = over_magnitudes(0.01, 0.2);
  return {.amplitude = chance(0.5) ? Vec{amplitude, 0} : Vec{0, amplitude},
          .frequency = over_magnitudes(0.3, 3),
          .phase = std::numbers::pi / 2};
}

bool add_apart(Scene& scene, Body body, double apart) {
  const double reach = reach_of(body) + apart;
  for (const Body& other : scene.bodies) {
    const Vec between = other.position - body.position;
    const double least = reach + reach_of(other);
    if (reach_of(other) > 0 && dot(between, between) < least * least) return false;
  }
  scene.bodies.push_back(std::move(body));
  return true;
}

namespace {

std::uint64_t seed_of(const Kind& kind, std::uint64_t seed, int n) {
  BitHash hash;
  hash.add(seed);
  hash.add(static_cast<std::uint64_t>(n));
  for (const char letter : kind.name) hash.add(static_cast<std::uint64_t>(static_cast<unsigned char>(letter)));
  return hash.value();
}

// Rare features of bodies, so that each meets every kind.
void season(Draw& draw, Scene& scene) {
  const bool in_layers = draw.chance(0.1);
  for (Body& body : scene.bodies) {
    if (in_layers && body.type == BodyType::dynamic && body.layers == Body{}.layers) {
      body.layers = static_cast<std::uint32_t>(draw.whole(1, 7));  // some meet, some pass; all meet what is fixed
    }
  }
  if (!draw.chance(0.2)) return;
  for (Body& body : scene.bodies) {
    if (body.type != BodyType::dynamic || !draw.chance(0.3)) continue;
    if (draw.chance(0.4)) body.linear_damping = draw.between(0, 2);
    if (draw.chance(0.3)) body.angular_damping = draw.between(0, 2);
    if (draw.chance(0.2)) body.gravity_scale = draw.between(-0.5, 2);
    if (body.angular_velocity == 0 && draw.chance(0.2)) body.fixed_rotation = true;
  }
}

}  // namespace

const Kind& find_kind(const std::string& name) { return find_entry<Kind>("kind", name); }

Scene drawn(const Kind& kind, std::uint64_t seed, int n) {
  Draw draw(seed_of(kind, seed, n));
  Scene scene = kind.scene(draw);
  season(draw, scene);
  scene.name = fmt::format("{}/{}", kind.name, n);
  scene.about = fmt::format("{} Drawn from seed {}.", kind.about, seed);
  return scene;
}

Scene drawn(const std::string& name, std::uint64_t seed) {
  const auto [kind, number] = split(name, '/');
  const std::optional<int> n = parse_integer(number);
  if (!n || *n < 0) {
    throw std::invalid_argument("\"" + name + "\": a random scene is KIND/N, such as heap/3; see plumb list kinds");
  }
  return drawn(find_kind(kind), seed, *n);
}

}  // namespace plumb
