#include <cmath>
#include <numbers>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::dominoes {
namespace {

constexpr double thick = 0.2;  // m
constexpr double height = 1;   // m

// s. The first one takes about 1/push to fall, and the wave runs on at about sqrt(g h) (Stronge, Proc. R. Soc. A 409
// (1987); Efthimiou and Johnson, SIAM Rev. 49 (2007)). The last one needs half a second to fall, and some engines half
// as much again to push it out of the ground. So short a time asks for the wave's speed, too: at half the gravity the
// last one still stands.
double duration(const Parameters& p) {
  const double wave = p.at("count") * p.at("spacing") / std::sqrt(standard_gravity * height);
  return whole_steps(wave + 1 / p.at("push") + 0.75);
}

std::string name(int i) { return "domino " + std::to_string(i); }

// The first one starts rotating about the foot it falls over, fast enough to pass its highest point.
Scene scene(const Parameters& p) {
  const Surface wood = surface(0.4, 0);
  const double push = p.at("push");
  Scene scene{.name = "dominoes", .about = "A row of dominoes, of which the first is pushed.", .duration = duration(p)};
  scene.bodies.push_back(level_ground(wood));
  for (int i = 1; i <= static_cast<int>(p.at("count")); ++i) {
    scene.bodies.push_back(box(name(i), {(i - 1) * p.at("spacing"), height / 2}, {thick, height}, wood));
  }
  Body& first = scene.bodies[1];
  first.angular_velocity = -push;
  first.velocity = {push * height / 2, push * thick / 2};
  return scene;
}

// Each domino falls against the next with more energy than it needs to tip it. The last has nothing to lean on: it lies
// flat, but one end may be deeper by the slop.
std::vector<Expectation> expectations(const Parameters& p) {
  const double end = duration(p);
  return {{.body = name(static_cast<int>(p.at("count"))),
           .quantity = Quantity::angle,
           .expected = -std::numbers::pi / 2,
           .allowed = [=](const Stepping& s) { return s.slop / height + round_off(s, end, height); },
           .source = "the last one lies on its side"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "dominoes",
     .question = "Does a row of dominoes fall down to the last one?",
     .parameters =
         {{.name = "count", .value = 10, .min = 2, .max = 100, .about = "number of dominoes", .whole = true},
          {.name = "spacing", .value = 0.6, .min = 0.5, .max = 0.7, .unit = "m", .about = "from one to the next"},
          {.name = "push",
           .value = 2,
           .min = 1,
           .max = 5,
           .unit = "rad/s",
           .about = "initial angular velocity of the first"}},
     .variants = {{"ten", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::dominoes
