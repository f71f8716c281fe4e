#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::spring {
namespace {

constexpr double length = 2;    // m
constexpr double duration = 5;  // s

Scene scene(const Parameters& p) {
  Scene scene{.name = "spring",
              .about = "A disc on a spring oscillates along a line.",
              .gravity = {0, 0},
              .duration = duration};
  scene.bodies.push_back(disc("disc", {length + p.at("amplitude"), 0}, 0.25, {}));
  const double mass = mass_of(scene.bodies[0]).mass;
  const double w = p.at("frequency");
  scene.forces.push_back(Spring{.b = 0, .stiffness = mass * w * w, .length = length});
  return scene;
}

// Errors of a method for x'' = -w^2 x, relative to the amplitude. Forces are evaluated at intervals of f, k = w f:
//   first      symplectic Euler (drift > 0) gives x half a step late or, if it moves first (drift < 0), early, and v
//              exactly: x_n = A cos((n +- 1/2) q)/cos(q/2), v_n = -A w' sin(n q). So x is off by |drift| w h. If
//              several sub-steps use the same force, v is off by |drift| w (f - h). The energy is off by
//              |drift| k w x v, at most |drift| k of it;
//   growth     a method that keeps no spring bounded multiplies the energy by at most 1 + k^2 per step;
//   frequency  (2/f) asin(k/2), of Verlet and both of the above: a phase of k^2/24 w t ahead, up to terms of k^4;
//   second     v is off by k^2/8, and the energy by k^2/4: Verlet keeps v^2 + w^2 (1 - k^2/4) x^2.
struct SpringErrors {
  double place = 0, speed = 0, energy = 0;
};

SpringErrors spring_errors(const Stepping& s, double w) {
  if (s.h == 0) return {};
  const double k = w * force_interval(s);
  const double first = std::abs(s.drift) * w;
  const bool grows = s.drift != 0 && s.spring_limit.value_or(0) == 0;
  const double w_dt = w * s.dt;
  const double grown = grows ? std::pow(1 + w_dt * w_dt, duration / (2 * s.dt)) - 1 : 0;
  const double common = grown + k * k / 24 * w * duration * (1 + k * k) + k * k / 8;
  const double held = std::max(force_interval(s) - s.h, 0.0);  // s, for which a force is the same in later sub-steps
  return {common + first * s.h, common + first * held, std::abs(s.drift) * k + k * k / 4 + grown * (2 + grown)};
}

std::vector<Expectation> expectations(const Parameters& p) {
  const double a = p.at("amplitude");
  const double w = p.at("frequency");
  const double mass = mass_of(scene(p).bodies[0]).mass;
  const double energy = mass * w * w * a * a / 2;
  const double speed = a * w;
  const auto round = [=](const Stepping& s) { return round_off(s, duration, length + a + speed * duration); };
  return {
      {.body = "disc",
       .quantity = Quantity::x,
       .allowed = [=](const Stepping& s) { return a * spring_errors(s, w).place + round(s); },
       .source = "A cos(w t); half a step off, or its growth, and a phase of k^2/24 w t"},
      {.body = "disc",
       .quantity = Quantity::vx,
       .allowed = [=](const Stepping& s) { return speed * spring_errors(s, w).speed + w * round(s); },
       .source = "-A w sin(w t); a phase of k^2/24 w t"},
      {.quantity = Quantity::energy,
       .allowed = [=](const Stepping& s) { return energy * spring_errors(s, w).energy + mass * w * speed * round(s); },
       .source = "constant; the method keeps an energy that differs by k w x v/2, or by k^2/4"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "spring",
     .question = "Does a mass on a spring oscillate at sqrt(k/m) and keep its energy as well as the method can?",
     .parameters = {{.name = "frequency", .value = 4, .min = 0.1, .max = 60, .unit = "rad/s", .about = "sqrt(k/m)"},
                    {.name = "amplitude", .value = 1, .min = 0.01, .max = 1.5, .unit = "m", .about = "at the start"}},
     .variants = {{"w=4", {}}, {"w=15", {{"frequency", 15}}}},
     .closed_form = "spring",
     .scene = scene,
     .expectations = expectations,
     .smoothness = [](const Parameters&) { return Smoothness::free; }}};

}  // namespace
}  // namespace plumb::scenarios::spring
