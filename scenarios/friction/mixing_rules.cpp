#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::mixing_rules {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 1;  // s, in which no rule stops it: sqrt(a^2 + b^2) g t is less than the speed
constexpr double speed = 12;    // m/s, at the start
const Vec size{1, 0.5};         // m; low enough not to tip: mu < b/h = 2

Surface surface_of(const Parameters& p, const char* whose) { return surface(p.at(whose), 0); }

Mixing mixing_of(const Parameters& p) {
  return {.friction = static_cast<FrictionMixing>(static_cast<int>(p.at("rule")))};
}

Scene scene(const Parameters& p) {
  Scene scene{.name = "mixing-rules",
              .about = "A box slides over ground that is rougher than it is.",
              .gravity = {0, -gravity},
              .duration = duration,
              .mixing = mixing_of(p)};
  scene.bodies.push_back(level_ground(surface_of(p, "ground")));
  Body sliding = box("box", {0, size.y / 2}, size, surface_of(p, "box"));
  sliding.velocity = {speed, 0};
  scene.bodies.push_back(sliding);
  return scene;
}

// Slower by mu g t. Friction that starts a lag late misses mu g lag of it, for all of the way; the way is off by the
// drift of mu g besides, by mu of the gap that the box sinks, and by what it leans, gap (height/length).
std::vector<Expectation> expectations(const Parameters& p) {
  const double mu = mixed_dynamic_friction(mixing_of(p), surface_of(p, "box"), surface_of(p, "ground"));
  const double a = mu * gravity;
  const double t = duration;
  const auto slower = [=](const Stepping& s) { return a * lag(s) + round_off(s, t, speed); };
  const auto place = [=](const Stepping& s) {
    return a * lag(s) * t + drifted(s, a, t) + (mu + size.y / size.x) * s.gap + round_off(s, t, 2 * speed * t);
  };
  return {{.body = "box",
           .quantity = Quantity::vx,
           .expected = speed - a * t,
           .allowed = slower,
           .source = "v - mu g t, mu by the rule; friction a lag late"},
          {.body = "box",
           .quantity = Quantity::x,
           .expected = speed * t - a * t * t / 2,
           .allowed = place,
           .source = "v t - mu g t^2/2, mu by the rule; friction a lag late, drift, sinking"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "mixing-rules",
     .question = "Do two surfaces rub as the scene's rule of mixing says?",
     .parameters = {{.name = "rule",
                     .value = 0,
                     .min = 0,
                     .max = 5,
                     .about = "0 geometric, 1 Pythagorean, 2 average, 3 min, 4 max, 5 product",
                     .whole = true},
                    {.name = "box", .value = 0.2, .min = 0, .max = 0.8, .about = "friction of the box"},
                    {.name = "ground", .value = 0.8, .min = 0, .max = 0.8, .about = "friction of the ground"}},
     .variants = {{"geometric", {}},
                  {"pythagorean", {{"rule", 1}}},
                  {"average", {{"rule", 2}}},
                  {"min", {{"rule", 3}}},
                  {"max", {{"rule", 4}}},
                  {"product", {{"rule", 5}}}},
     .closed_form = "slide",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::mixing_rules
