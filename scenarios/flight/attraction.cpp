#include <cmath>
#include <numbers>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/random.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::orbit {
namespace {

double strength(const Parameters& p) {
  const double n = 2 * std::numbers::pi / p.at("period");
  const double a = p.at("axis");
  return n * n * a * a * a;
}

// One period, starting from the far end of the ellipse.
Scene scene(const Parameters& p) {
  const double a = p.at("axis");
  const double e = p.at("eccentricity");
  Scene scene{.name = "orbit",
              .about = "A planet orbits a sun that attracts it with 1/r^2.",
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

// A step of symplectic Euler keeps the modified energy H - drift dt v.a (m = 1) constant, except for Verlet's terms,
//   dt^2 (v.V''v/12 - |a|^2/24).
// The worst place is the near end r: v.a <= v k/r^2, v.V''v <= 2 k v^2/r^3 and |a| = k/r^2. A step of explicit Euler
// adds dt^2 (|a|^2 + v.V''v)/2 every time and multiplies the angular momentum by 1 + dt^2 k/r^3. The other methods
// conserve angular momentum because a central force has no moment.
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
    const double grown = grows(s) ? end * s.dt / 2 * (pull * pull + 2 * k * v * v / (r * r * r)) : 0;
    return mass * (first + second + grown) + mass * v * round_off(s, end, v + pull * s.dt);
  };
  const auto momentum = [=](const Stepping& s) {
    const double grown = grows(s) ? std::expm1(end * s.dt * k / (r * r * r)) : 0;
    return mass * (r * v * grown + round_off(s, end, 2 * a * v));
  };
  // A relative error of the energy, per mass, changes the period by 3/2 of it, and so the place along the orbit, at no
  // more than the speed v. The modified motion is off the true one by as much again (its potential turns the ellipse),
  // and by half a step of the drift.
  const auto place = [=](const Stepping& s) {
    const double relative = energy(s) / (mass * k / (2 * a));
    return v * (3 * relative * end + 2 * std::abs(s.drift) * s.h) + round_off(s, end, 2 * a + v * end);
  };
  const Expectation at_third{.body = "planet",
                             .time = std::round(end * 20) / 60,
                             .allowed = place,
                             .source = "Kepler's equation; the error of the energy shifts the period"};
  Expectation x = at_third;
  x.quantity = Quantity::x;
  Expectation y = at_third;
  y.quantity = Quantity::y;
  return {x,
          y,
          {.quantity = Quantity::energy, .allowed = energy, .source = "constant; error: the modified energy at r_min"},
          {.quantity = Quantity::angular_momentum,
           .allowed = momentum,
           .source = "constant; only explicit Euler increases it"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "orbit",
     .question = "Does a planet in orbit keep its energy and angular momentum?",
     .parameters =
         {{.name = "axis", .value = 4, .min = 1, .max = 100, .unit = "m", .about = "semi-major axis of the orbit"},
          {.name = "eccentricity", .value = 0.3, .min = 0, .max = 0.9, .about = "of the orbit"},
          {.name = "period",
           .value = 6,
           .min = 1,
           .max = 60,
           .unit = "s",
           .about = "of the orbit, 2 pi sqrt(a^3/k)",
           .whole = true}},
     .variants = {{"round", {{"eccentricity", 0}}}, {"ellipse", {}}},
     .closed_form = "orbit",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::orbit

namespace plumb::scenarios::heavy_object {
namespace {

constexpr double duration = 3;  // s
constexpr double ratio = 1000;  // density of the heavy disc over that of the others

// The heavy disc flies along the x axis. The others fly the opposite way, each on its own line and all on no layer, so
// that nothing collides.
Scene scene(const Parameters& p) {
  Random random(static_cast<std::uint64_t>(p.at("seed")));
  Scene scene{.name = "heavy-object",
              .about = "A heavy disc flies past light ones and attracts them.",
              .gravity = {0, 0},
              .duration = duration};
  Body heavy = disc("heavy", {0, 0}, 0.5, surface(0, 0, ratio));
  heavy.velocity = {p.at("speed"), 0};
  heavy.layers = 0;
  scene.bodies.push_back(heavy);
  for (int i = 1; i <= static_cast<int>(p.at("passers")); ++i) {
    const double side = i % 2 == 0 ? 1 : -1;
    Body passer = disc("passer " + std::to_string(i), {random.between(3, 6), side * random.between(2, 4)}, 0.2, {});
    passer.velocity = {-random.between(1, 3), 0};
    passer.layers = 0;
    scene.bodies.push_back(passer);
  }
  scene.forces.push_back(Attraction{.from = 0, .strength = p.at("strength"), .mutual = p.at("mutual") == 1});
  return scene;
}

// One-sided: the heavy disc flies on in a straight line, by Newton's first law and as in the article's pseudocode; its
// pull on the others is work done from outside. Mutual: the forces are opposite and momentum is constant, for every
// Runge-Kutta method too, because momentum is linear in the state. (Angular momentum is not linear, and only symplectic
// methods keep it to the last bit.)
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene all = scene(p);
  const double v = p.at("speed");
  if (p.at("mutual") == 0) {
    const auto place = [=](const Stepping& s) { return round_off(s, duration, v * duration); };
    const auto speed = [=](const Stepping& s) { return round_off(s, duration, v); };
    return {{.body = "heavy", .quantity = Quantity::x, .expected = v * duration, .allowed = place, .source = "v t"},
            {.body = "heavy",
             .quantity = Quantity::vx,
             .expected = v,
             .allowed = speed,
             .source = "constant: no force acts on it"}};
  }
  double momentum = 0;
  double largest = 0;
  for (const Body& body : all.bodies) {
    const double mass = mass_of(body).mass;
    momentum += mass * body.velocity.x;
    largest += mass * std::abs(body.velocity.x);
  }
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, largest); };
  return {{.quantity = Quantity::momentum_x,
           .expected = momentum,
           .allowed = exact,
           .source = "constant: the forces are equal and opposite"},
          {.quantity = Quantity::momentum_y,
           .expected = 0,
           .allowed = exact,
           .source = "constant: the forces are equal and opposite"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "heavy-object",
     .question =
         "Does a heavy body attract the bodies it passes, and do they act back on it only if the attraction is mutual?",
     .parameters =
         {{.name = "passers",
           .value = 12,
           .min = 1,
           .max = 1000,
           .about = "number of light discs that it attracts",
           .whole = true},
          {.name = "strength",
           .value = 20,
           .min = 0.1,
           .max = 1000,
           .unit = "m^3/s^2",
           .about = "acceleration times r^2"},
          {.name = "speed", .value = 2, .min = 0, .max = 20, .unit = "m/s", .about = "of the heavy body"},
          {.name = "mutual",
           .value = 0,
           .min = 0,
           .max = 1,
           .about = "1: the opposite forces act on the heavy body",
           .whole = true},
          {.name = "seed", .value = 1, .min = 0, .max = 1e6, .about = "of the random arrangement", .whole = true}},
     .variants = {{"one-sided", {}}, {"mutual", {{"mutual", 1}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::heavy_object
