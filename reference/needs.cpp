#include "reference/needs.h"

#include <algorithm>
#include <array>

#include "reference/exact/recognise.h"
#include "reference/meeting.h"
#include "reference/scene_facts.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

struct Facts {
  const Scene& scene;
  std::string none_meet;  // why; "" where some might
  bool frictionless = false;
  bool inelastic = false;
};

/// What may be left out, and why: "" where it may not.
struct Rule {
  const char* option;
  const char* value;
  std::string (*why)(const Facts&);
};

template <class Coefficient>
bool is_zero(const Scene& scene, Coefficient coefficient) {
  std::vector<Surface> seen;
  const auto zero = [&](const Surface& a, const Surface& b) { return coefficient(scene.mixing, a, b) == 0; };
  for (const Body& body : scene.bodies) {
    for (const Shape& shape : body.shapes) {
      const Surface& one = shape.surface;
      const bool known = std::any_of(seen.begin(), seen.end(), [&](const Surface& other) {
        return one.static_friction == other.static_friction && one.dynamic_friction == other.dynamic_friction &&
               one.restitution == other.restitution;
      });
      if (known) continue;
      seen.push_back(one);
      if (!std::all_of(seen.begin(), seen.end(), [&](const Surface& other) { return zero(one, other); })) return false;
    }
  }
  return true;
}

struct Torque {
  const Scene& scene;

  bool central(std::size_t body, Vec anchor) const {
    return scene.bodies[body].type != BodyType::dynamic || anchor == mass_of(scene.bodies[body]).center;
  }
  bool operator()(const Attraction&) const { return false; }
  bool operator()(const Constant& constant) const { return constant.torque != 0; }
  bool operator()(const Spring& spring) const {
    return !central(spring.b, spring.anchor_b) || (spring.a && !central(*spring.a, spring.anchor_a));
  }
};

// Forces on a smooth disc go through its centre.
bool is_disc(const Body& body) {
  const Circle* circle = lone<Circle>(body);
  return circle != nullptr && circle->center == Vec{};
}

std::string why_none_turns(const Facts& facts) {
  const Scene& scene = facts.scene;
  if (!scene.joints.empty()) return "";
  if (std::any_of(scene.forces.begin(), scene.forces.end(),
                  [&](const Force& force) { return std::visit(Torque{scene}, force); })) {
    return "";
  }
  for (const Body& body : scene.bodies) {
    if (body.type != BodyType::dynamic) continue;
    if (body.angular_velocity != 0) return "";
    if (facts.none_meet.empty() && !(facts.frictionless && is_disc(body))) return "";
  }
  return facts.none_meet.empty() ? "no body turns at first, and no force on a smooth disc is off its centre"
                                 : "no body turns at first, and no force is off a centre of mass";
}

// Not among them: precision, since how far round-off grows hangs on the step; sleeping and coarser steps, since no
// scene shows beforehand that a body will rest, or how much an error matters.
constexpr std::array rules{
    Rule{"contacts", "off", [](const Facts& facts) { return facts.none_meet; }},
    Rule{"continuous", "off",
         [](const Facts& facts) -> std::string {
           return facts.none_meet.empty() ? "" : "what meets nothing tunnels through nothing";
         }},
    Rule{"rotation", "off", why_none_turns},
    Rule{"friction", "off",
         [](const Facts& facts) -> std::string {
           return facts.frictionless ? "every mixed coefficient of friction is 0" : "";
         }},
    Rule{"restitution", "off",
         [](const Facts& facts) -> std::string { return facts.inelastic ? "every mixed restitution is 0" : ""; }},
};

}  // namespace

std::vector<Choice> needless(const Scene& scene) {
  Facts facts{.scene = scene, .none_meet = why_none_meet(scene)};
  facts.frictionless = is_zero(scene, mixed_static_friction);
  facts.inelastic = is_zero(scene, mixed_restitution);
  std::vector<Choice> choices;
  for (const Rule& rule : rules) {
    if (const std::string why = rule.why(facts); !why.empty()) choices.push_back({rule.option, rule.value, why});
  }
  return choices;
}

}  // namespace plumb
