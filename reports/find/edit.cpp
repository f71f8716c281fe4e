#include "reports/find/shrink.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>
#include <type_traits>
#include <variant>
#include <vector>

#include "reports/judge/mechanics.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/scene_json.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

// What rounding leaves of nothing is nothing.
double rounded(double value, int digits) {
  constexpr double nothing = 1e-9;
  if (!std::isfinite(value)) return value;
  if (std::abs(value) < nothing) return 0;
  const double least = std::pow(10.0, digits - 1);  // with that many digits
  double scale = 1;
  while (std::abs(value) * scale < least) scale *= 10;
  return std::round(value * scale) / scale;
}

// Whole numbers stay, and unit vectors, which rounded ones are not.
void round_all(Json& json, int digits) {
  if (json.is_number_float()) json = rounded(json.get<double>(), digits);
  if (json.is_array()) {
    for (Json& one : json) round_all(one, digits);
  }
  if (!json.is_object()) return;
  for (auto& [key, value] : json.items()) {
    if (key != "normal" && key != "axis") round_all(value, digits);
  }
}

void round_body(Json& body, int digits) {
  for (const char* key : {"position", "angle", "velocity", "angularVelocity", "gravityScale", "linearDamping",
                          "angularDamping", "path", "shapes"}) {
    if (body.contains(key)) round_all(body[key], digits);
  }
}

void fit_rods(Scene& scene) {
  for (Joint& joint : scene.joints) {
    auto* rod = std::get_if<Distance>(&joint);
    if (rod != nullptr && rod->stiffness == 0) rod->length = length(rod->anchor_b - rod->anchor_a);
  }
}

void shift(std::optional<Limits>& limits, double by) {
  if (limits) *limits = {limits->low - by, limits->high - by};
}

}  // namespace

std::optional<Scene> with_digits(const Scene& scene, int digits, std::optional<std::size_t> body) {
  Json json = Json::parse(write_scene({.scene = scene, .truth = {}}));
  if (body) {
    round_body(json["bodies"][*body], digits);
  } else {
    for (Json& one : json["bodies"]) round_body(one, digits);
    for (const char* key : {"gravity", "duration", "joints", "forces"}) {
      if (json.contains(key)) round_all(json[key], digits);
    }
  }
  try {
    Scene rounder = read_scene(json.dump(), "a simpler scene").scene;
    fit_rods(rounder);
    return rounder;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

Scene started_at(const Scene& scene, std::span<const BodyState> states, double time) {
  const std::vector<BodyState> before = initial_states(scene);
  Scene later = scene;
  later.duration -= time;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    Body& body = later.bodies[i];
    if (body.type == BodyType::fixed) continue;
    body.angle = states[i].angle;
    body.position = states[i].position - rotated(mass_of(body).center, body.angle);
    if (body.type == BodyType::dynamic) body.velocity = states[i].velocity;
    if (body.type == BodyType::dynamic) body.angular_velocity = states[i].angular_velocity;
    if (body.path) body.path->phase += 2 * std::numbers::pi * body.path->frequency * time;
  }
  const auto turn_of = [&](std::size_t body) { return states[body].angle - before[body].angle; };
  const auto carried = [&](std::size_t body, Vec point) {
    return states[body].position + rotated(point - before[body].position, turn_of(body));
  };
  for (Joint& joint : later.joints) {
    std::visit(
        [&](auto& one) {
          using Tie = std::decay_t<decltype(one)>;
          if constexpr (std::is_same_v<Tie, Distance>) {
            one.anchor_a = carried(one.a, one.anchor_a);
            one.anchor_b = carried(one.b, one.anchor_b);
          } else {
            const Vec at_a = carried(one.a, one.anchor);
            const Vec at_b = carried(one.b, one.anchor);
            one.anchor = at_a;
            if constexpr (std::is_same_v<Tie, Revolute>) shift(one.limits, turn_of(one.b) - turn_of(one.a));
            if constexpr (std::is_same_v<Tie, Prismatic>) {
              one.axis = rotated(one.axis, turn_of(one.a));
              shift(one.limits, dot(one.axis, at_b - at_a));
            }
          }
        },
        joint);
  }
  return later;
}

Scene without_bodies(const Scene& scene, std::size_t begin, std::size_t end) {
  const auto gone = [&](std::size_t body) { return body >= begin && body < end; };
  const auto moved = [&](std::size_t body) { return body < begin ? body : body - (end - begin); };
  Scene rest = scene;
  rest.bodies.erase(rest.bodies.begin() + static_cast<std::ptrdiff_t>(begin),
                    rest.bodies.begin() + static_cast<std::ptrdiff_t>(end));
  rest.joints.clear();
  for (Joint joint : scene.joints) {
    const bool lost = std::visit([&](const auto& one) { return gone(one.a) || gone(one.b); }, joint);
    if (lost) continue;
    std::visit(
        [&](auto& one) {
          one.a = moved(one.a);
          one.b = moved(one.b);
        },
        joint);
    rest.joints.push_back(joint);
  }
  rest.forces.clear();
  for (Force force : scene.forces) {
    const bool lost = std::visit(
        [&](auto& one) {
          using Tie = std::decay_t<decltype(one)>;
          if constexpr (std::is_same_v<Tie, Attraction>) {
            const bool without = gone(one.from);
            one.from = moved(one.from);
            return without;
          } else if constexpr (std::is_same_v<Tie, Spring>) {
            const bool without = gone(one.b) || (one.a && gone(*one.a));
            one.b = moved(one.b);
            if (one.a) one.a = moved(*one.a);
            return without;
          } else {
            const bool without = gone(one.body);
            one.body = moved(one.body);
            return without;
          }
        },
        force);
    if (!lost) rest.forces.push_back(force);
  }
  return rest;
}

}  // namespace plumb
