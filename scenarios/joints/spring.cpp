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

// The error of a first-order method for x'' = -w^2 x, relative to the amplitude, with k = w dt (a force is evaluated
// once per step, whatever the number of sub-steps):
//   symplectic Euler (drift > 0) conserves v^2 + w^2 x^2 - k w v x exactly: off by at most k/2 of the amplitude, either
//     way;
//   explicit Euler (drift < 0) multiplies the energy by 1 + k^2 per step, the amplitude by (1 + k^2)^(t/(2 dt));
//   the frequency of both, and of Verlet, is (2/dt) asin(k/2): a phase of k^2/24 w t ahead, up to terms of k^4.
// At most the amplitude itself: if the bound is larger than that, the method states nothing.
double relative_error(const Stepping& s, double w) {
  const double k = w * s.dt;
  if (s.h == 0) return 0;
  const double grown = s.drift < 0 ? std::pow(1 + k * k, duration / (2 * s.dt)) - 1 : 0;
  return std::min(2 * std::abs(s.drift) * k + grown + k * k / 24 * w * duration * (1 + k * k), 1.0);
}

std::vector<Expectation> expectations(const Parameters& p) {
  const double a = p.at("amplitude");
  const double w = p.at("frequency");
  const double mass = mass_of(scene(p).bodies[0]).mass;
  const double energy = mass * w * w * a * a / 2;
  const double speed = a * w;
  const auto round = [=](const Stepping& s) { return round_off(s, duration, length + a + speed * duration); };
  return {{.body = "disc",
           .quantity = Quantity::x,
           .allowed = [=](const Stepping& s) { return a * relative_error(s, w) + round(s); },
           .source = "A cos(w t); error k = w dt of the method, or its growth, and a phase of k^2/24 w t"},
          {.body = "disc",
           .quantity = Quantity::vx,
           .allowed = [=](const Stepping& s) { return speed * relative_error(s, w) + w * round(s); },
           .source = "-A w sin(w t); the same relative error"},
          {.quantity = Quantity::energy,
           .allowed =
               [=](const Stepping& s) {
                 return energy * (2 * relative_error(s, w) + relative_error(s, w) * relative_error(s, w)) +
                        mass * w * speed * round(s);
               },
           .source = "constant; twice the relative error of the amplitude"}};
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
