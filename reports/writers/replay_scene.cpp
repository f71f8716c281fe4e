#include "reports/writers/replay_scene.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <variant>

#include "reports/judge/mechanics.h"
#include "reports/judge/overlap.h"
#include "reports/vec.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json pair_of(Vec v) { return Json::array({v.x, v.y}); }

Json json_of(const Outline& outline) {
  if (outline.halfspace) return {{"normal", pair_of(outline.halfspace->normal)}, {"offset", outline.halfspace->offset}};
  Json points = Json::array();
  for (const Vec point : outline.points) points.push_back(pair_of(point));
  return {{"points", points}, {"radius", outline.radius}};
}

const char* name_of(BodyType type) {
  switch (type) {
    case BodyType::fixed:
      return "fixed";
    case BodyType::kinematic:
      return "kinematic";
    case BodyType::dynamic:
      return "dynamic";
  }
  return "";
}

Json ties_of(const Scene& scene) {
  const std::vector<BodyState> start = initial_states(scene);
  const auto local = [&](std::size_t body, Vec anchor) {
    return pair_of(rotated(anchor - start[body].position, -start[body].angle));
  };
  Json ties = Json::array();
  for (const Joint& joint : scene.joints) {
    const auto [a, b, at_a, at_b] = std::visit(
        [](const auto& of) {
          if constexpr (requires { of.anchor_a; })
            return std::tuple(of.a, of.b, of.anchor_a, of.anchor_b);
          else
            return std::tuple(of.a, of.b, of.anchor, of.anchor);
        },
        joint);
    ties.push_back({{"a", a}, {"b", b}, {"at_a", local(a, at_a)}, {"at_b", local(b, at_b)}});
  }
  for (const Force& force : scene.forces) {
    const auto* spring = std::get_if<Spring>(&force);
    if (spring == nullptr) continue;
    const auto of_body = [&](std::size_t body, Vec anchor) {
      return pair_of(anchor - mass_of(scene.bodies[body]).center);
    };
    ties.push_back({{"a", spring->a ? Json(*spring->a) : Json()},
                    {"b", spring->b},
                    {"at_a", spring->a ? of_body(*spring->a, spring->anchor_a) : pair_of(spring->anchor_a)},
                    {"at_b", of_body(spring->b, spring->anchor_b)}});
  }
  return ties;
}

}  // namespace

Json outlines_of(const Scene& scene) {
  Json outlines = Json::array();
  Json bodies = Json::array();
  std::map<std::string, std::size_t> known;
  for (const Body& body : scene.bodies) {
    const Vec center = mass_of(body).center;
    Json indices = Json::array();
    for (const Shape& shape : body.shapes) {
      Json outline = json_of(outline_of(shape.geometry, center));
      const auto [place, added] = known.try_emplace(outline.dump(), outlines.size());
      if (added) outlines.push_back(std::move(outline));
      indices.push_back(place->second);
    }
    bodies.push_back({{"name", body.name}, {"type", name_of(body.type)}, {"outlines", indices}});
  }
  return {{"outlines", outlines}, {"bodies", bodies}, {"ties", ties_of(scene)}};
}

std::vector<double> radii_of(const Scene& scene) {
  std::vector<double> radii;
  for (const Body& body : scene.bodies) {
    const Vec center = mass_of(body).center;
    double radius = 0;
    for (const Shape& shape : body.shapes) {
      const Outline outline = outline_of(shape.geometry, center);
      for (const Vec point : outline.points) radius = std::max(radius, length(point) + outline.radius);
    }
    radii.push_back(radius);
  }
  return radii;
}

}  // namespace plumb
