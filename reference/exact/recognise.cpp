#include "reference/exact/recognise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace plumb {
namespace {

// A face of a body in the world frame.
Floor world_floor(Vec normal, double offset, const Body& body, double from, double to) {
  const Vec n = rotated(normal, body.angle);
  const Floor here{.normal = n, .offset = offset + dot(n, body.position)};
  const double shift = dot(here.along(), body.position);
  return {n, here.offset, from + shift, to + shift};
}

bool stands_over(const Floor& floor, Vec point) {
  const double here = dot(floor.along(), point);
  return dot(floor.normal, point) > floor.offset && floor.from <= here && here <= floor.to;
}

}  // namespace

std::string textbook_refusal(const Scene& scene) {
  if (!scene.joints.empty()) return "does not support joints";
  if (!scene.forces.empty()) return "supports no force except gravity";
  for (const Body& body : scene.bodies) {
    if (body.linear_damping != 0 || body.angular_damping != 0) return "does not support damping";
  }
  return "";
}

std::string contact_refusal(const Scene& scene) {
  for (const Body& body : scene.bodies) {
    for (const Body& other : scene.bodies) {
      if (body.type == BodyType::dynamic && (body.layers & other.layers) == 0)
        return "handles only bodies that share a layer";
    }
  }
  return textbook_refusal(scene);
}

std::optional<Floor> floor_of(const Body& body, Vec gravity, std::optional<Vec> above) {
  if (body.type != BodyType::fixed) return std::nullopt;
  if (const HalfSpace* half = only_shape<HalfSpace>(body)) {
    constexpr double far = std::numeric_limits<double>::infinity();
    return world_floor(half->normal, half->offset, body, -far, far);
  }
  const Box* box = only_shape<Box>(body);
  if (box == nullptr) return std::nullopt;
  const Vec sides[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const double extents[] = {box->size.x / 2, box->size.y / 2};
  std::optional<Floor> best;
  for (std::size_t side = 0; side < 4; ++side) {
    const Vec normal = rotated(sides[side], box->angle);
    const double reach = extents[(side + 1) % 2];
    const double middle = dot({normal.y, -normal.x}, box->center);
    const double offset = extents[side % 2] + dot(normal, box->center);
    const Floor face = world_floor(normal, offset, body, middle - reach, middle + reach);
    if (above && stands_over(face, *above)) return face;
    if (!best || dot(face.normal, gravity) < dot(best->normal, gravity)) best = face;
  }
  return best;
}

std::optional<BodyOnGround> single_body_on_ground(const Scene& scene) {
  if (scene.bodies.size() != 2) return std::nullopt;
  for (const std::size_t ground : {std::size_t{0}, std::size_t{1}}) {
    const std::size_t body = 1 - ground;
    if (scene.bodies[ground].type == BodyType::fixed && scene.bodies[body].type == BodyType::dynamic) {
      return BodyOnGround{ground, body};
    }
  }
  return std::nullopt;
}

std::optional<BodyOnFloor> single_body_on_floor(const Scene& scene) {
  BodyOnFloor found{.body = scene.bodies.size(), .ground = scene.bodies.size()};
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].shapes.empty()) return std::nullopt;
    const bool moves = scene.bodies[i].type == BodyType::dynamic;
    std::size_t& slot = moves ? found.body : found.ground;
    if (moves && slot != scene.bodies.size()) return std::nullopt;
    slot = i;
  }
  if (found.body == scene.bodies.size() || found.ground == scene.bodies.size()) return std::nullopt;
  const Body& body = scene.bodies[found.body];
  const Coefficients mixed = mixed_coefficients(scene, scene.bodies[found.ground], body);
  std::vector<Floor> tiles;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (i == found.body) continue;
    const std::optional<Floor> tile = floor_of(scene.bodies[i], gravity_of(scene, body), body.position);
    if (!tile || mixed_coefficients(scene, scene.bodies[i], body) != mixed) return std::nullopt;
    tiles.push_back(*tile);
  }
  std::sort(tiles.begin(), tiles.end(), [](const Floor& a, const Floor& b) { return a.from < b.from; });
  found.floor = tiles.front();
  for (std::size_t i = 1; i < tiles.size(); ++i) {
    const bool level = length(tiles[i].normal - found.floor.normal) < geometry_tolerance &&
                       std::abs(tiles[i].offset - found.floor.offset) < geometry_tolerance;
    if (!level || std::abs(tiles[i].from - found.floor.to) > geometry_tolerance) return std::nullopt;
    found.floor.to = tiles[i].to;
  }
  return found;
}

std::optional<Footprint> footprint(const Box& box, double angle, const Floor& floor) {
  const double off = angle + box.angle - std::atan2(floor.along().y, floor.along().x);
  const double quarters = std::round(off / (std::numbers::pi / 2));
  if (std::abs(off - quarters * std::numbers::pi / 2) > geometry_tolerance) return std::nullopt;
  if (std::fmod(quarters, 2.0) != 0) return Footprint{box.size.y, box.size.x};
  return Footprint{box.size.x, box.size.y};
}

Coefficients mixed_coefficients(const Scene& scene, const Body& a, const Body& b) {
  const Surface& one = a.shapes.front().surface;
  const Surface& other = b.shapes.front().surface;
  return {mixed_static_friction(scene.mixing, one, other), mixed_dynamic_friction(scene.mixing, one, other),
          mixed_restitution(scene.mixing, one, other)};
}

}  // namespace plumb
