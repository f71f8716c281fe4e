#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/random.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::heavy_object {
namespace {

constexpr double duration = 3;  // s
constexpr double ratio = 1000;  // density of the heavy disc to the others

// The heavy one flies along the x axis; the others come the other way, each on a line of its own and on a layer of its
// own.
Scene scene(const Parameters& p) {
  Random random(static_cast<std::uint64_t>(p.at("seed")));
  Scene scene{.name = "heavy-object",
              .about = "A heavy disc flies past light ones and draws them to itself.",
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

// One-sided, the heavy disc flies on as Newton's first law has it, and the article's pseudocode; what it does to the
// others is work from outside. Mutual, the forces are opposite: the momentum is constant, for every Runge-Kutta method
// too, as it is linear in the state. (Angular momentum is not, and only symplectic methods keep it to the last bit.)
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene all = scene(p);
  const double v = p.at("speed");
  if (p.at("mutual") == 0) {
    const auto place = [=](const Stepping& s) { return round_off(s, duration, v * duration); };
    const auto speed = [=](const Stepping& s) { return round_off(s, duration, v); };
    return {{.body = "heavy", .quantity = Quantity::x, .expected = v * duration, .allowed = place, .source = "v t"},
            {.body = "heavy", .quantity = Quantity::vx, .expected = v, .allowed = speed, .source = "feels nothing"}};
  }
  double momentum = 0;
  double largest = 0;
  for (const Body& body : all.bodies) {
    const double mass = mass_of(body).mass;
    momentum += mass * body.velocity.x;
    largest += mass * std::abs(body.velocity.x);
  }
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, largest); };
  return {{.quantity = Quantity::momentum_x, .expected = momentum, .allowed = exact, .source = "forces are opposite"},
          {.quantity = Quantity::momentum_y, .expected = 0, .allowed = exact, .source = "forces are opposite"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "heavy-object",
     .question = "Does a heavy body draw those it passes, and feel what it should of them?",
     .parameters =
         {{.name = "passers", .value = 12, .min = 1, .max = 1000, .about = "that it attracts", .whole = true},
          {.name = "strength", .value = 20, .min = 0.1, .max = 1000, .unit = "m^3/s^2", .about = "times 1/r^2"},
          {.name = "speed", .value = 2, .min = 0, .max = 20, .unit = "m/s", .about = "of the heavy body"},
          {.name = "mutual", .value = 0, .min = 0, .max = 1, .about = "1: it feels the opposite forces", .whole = true},
          {.name = "seed", .value = 1, .min = 0, .max = 1e6, .about = "of the arrangement", .whole = true}},
     .variants = {{"one-sided", {}}, {"mutual", {{"mutual", 1}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::heavy_object
