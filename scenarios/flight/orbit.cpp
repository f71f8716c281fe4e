#include <cmath>
#include <numbers>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::orbit {
namespace {

double strength(const Parameters& p) {
  const double n = 2 * std::numbers::pi / p.at("period");
  const double a = p.at("axis");
  return n * n * a * a * a;
}

// From the far end of the ellipse, one period.
Scene scene(const Parameters& p) {
  const double a = p.at("axis");
  const double e = p.at("eccentricity");
  Scene scene{.name = "orbit",
              .about = "A planet about a sun that attracts with 1/r^2.",
              .gravity = {0, 0},
              .duration = p.at("period")};
  Body sun = disc("sun", {0, 0}, 0.3, {});
  sun.type = BodyType::fixed;
  sun.layers = 1;
  Body planet = disc("planet", {a * (1 + e), 0}, 0.1, {});
  planet.layers = 2;
  planet.velocity = {0, std::sqrt(strength(p) / a * (1 - e) / (1 + e))};
  scene.bodies = {sun, planet};
  scene.forces.push_back(Attraction{.from = 0, .strength = strength(p)});
  return scene;
}

// Of a symplectic Euler step the modified energy H - drift dt v.a (m = 1) is constant, to the terms of Verlet's,
//   dt^2 (v.V''v/12 - |a|^2/24);
// at the near end r, the worst place, v.a <= v k/r^2, v.V''v <= 2 k v^2/r^3 and |a| = k/r^2. A step of explicit Euler
// adds dt^2 (|a|^2 + v.V''v)/2 every time, and multiplies the angular momentum by 1 + dt^2 k/r^3, which the others
// keep: the pull has no moment.
std::vector<Expectation> expectations(const Parameters& p) {
  const double k = strength(p);
  const double a = p.at("axis");
  const double e = p.at("eccentricity");
  const double r = a * (1 - e);
  const double v = std::sqrt(k / a * (1 + e) / (1 - e));
  const double end = p.at("period");
  const double mass = mass_of(scene(p).bodies[1]).mass;
  const double pull = k / (r * r);
  const auto energy = [=](const Stepping& s) {
    if (s.h == 0) return mass * v * round_off(s, end, v);
    const double first = 2 * std::abs(s.drift) * s.dt * v * pull;
    const double second = 2 * s.dt * s.dt * (2 * k * v * v / (r * r * r) / 12 + pull * pull / 24);
    const double grown = s.drift < 0 ? end * s.dt / 2 * (pull * pull + 2 * k * v * v / (r * r * r)) : 0;
    return mass * (first + second + grown) + mass * v * round_off(s, end, v + pull * s.dt);
  };
  const auto momentum = [=](const Stepping& s) {
    const double grown = s.drift < 0 ? std::expm1(end * s.dt * k / (r * r * r)) : 0;
    return mass * (r * v * grown + round_off(s, end, 2 * a * v));
  };
  return {
      {.quantity = Quantity::energy, .allowed = energy, .source = "constant; the method's modified energy at r_min"},
      {.quantity = Quantity::angular_momentum, .allowed = momentum, .source = "constant, but for explicit Euler"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "orbit",
     .question = "Does a planet keep its energy and its areal speed?",
     .parameters =
         {{.name = "axis", .value = 4, .min = 1, .max = 100, .unit = "m", .about = "semi-major"},
          {.name = "eccentricity", .value = 0.3, .min = 0, .max = 0.9, .about = "of the ellipse"},
          {.name = "period", .value = 6, .min = 1, .max = 60, .unit = "s", .about = "2 pi sqrt(a^3/k)", .whole = true}},
     .variants = {{"round", {{"eccentricity", 0}}}, {"ellipse", {}}},
     .closed_form = "orbit",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::orbit
