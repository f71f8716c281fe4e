#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::restitution_rules {
namespace {

constexpr double duration = 1;  // s
constexpr double radius = 0.5;  // m
constexpr double apart = 0.93;  // m from the wall at the start

Mixing mixing_of(const Parameters& p) {
  return {.restitution = static_cast<RestitutionMixing>(static_cast<int>(p.at("rule")))};
}

Scene scene(const Parameters& p) {
  Scene scene{.name = "restitution-rules",
              .about = "A disc bounces off ground with another restitution, without gravity.",
              .gravity = {0, 0},
              .duration = duration,
              .mixing = mixing_of(p)};
  scene.bodies.push_back(level_ground(surface(0, p.at("ground"))));
  Body ball = disc("disc", {0, radius + apart}, radius, surface(0, p.at("disc")));
  ball.velocity = {0, -p.at("speed")};
  scene.bodies.push_back(ball);
  return scene;
}

// It leaves with e v, whenever the impact is detected. Its position is off by the velocity jump times the lag and by
// the penetration that may be corrected.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double e = mixed_restitution(mixing_of(p), surface(0, p.at("disc")), surface(0, p.at("ground")));
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, 2 * radius + v * duration); };
  const auto place = [=](const Stepping& s) { return (2 + e) * v * lag(s) + s.contact_gap() + exact(s); };
  return {
      {.body = "disc", .quantity = Quantity::vy, .expected = e * v, .allowed = exact, .source = "e v, e by the rule"},
      {.body = "disc",
       .quantity = Quantity::y,
       .expected = radius + e * v * (duration - apart / v),
       .allowed = place,
       .source = "e v from the impact on; the velocity jump times the lag, and the penetration"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "restitution-rules",
     .question = "Does the restitution between two surfaces follow the scene's mixing rule?",
     .parameters = {{.name = "rule",
                     .value = 0,
                     .min = 0,
                     .max = 3,
                     .about = "0 max, 1 min, 2 average, 3 product",
                     .whole = true},
                    {.name = "speed", .value = 3, .min = 2, .max = 20, .unit = "m/s", .about = "of the approach"},
                    {.name = "disc", .value = 0.9, .min = 0, .max = 1, .about = "restitution of the disc"},
                    {.name = "ground", .value = 0.4, .min = 0, .max = 1, .about = "restitution of the ground"}},
     .variants = {{"max", {}}, {"min", {{"rule", 1}}}, {"average", {{"rule", 2}}}, {"product", {{"rule", 3}}}},
     .closed_form = "first-impact",
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::restitution_rules
