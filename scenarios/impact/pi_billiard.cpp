#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::pi_billiard {
namespace {

constexpr double duration = 6;  // s
constexpr double speed = 2;     // m/s, of the heavy block towards the light one

Scene scene(const Parameters& p) {
  const Surface elastic = surface(0, 1);
  Scene scene{.name = "pi-billiard",
              .about = "A heavy block drives a light one against a wall, without friction or loss.",
              .gravity = {0, 0},
              .duration = duration};
  Body wall = level_ground(elastic);
  wall.name = "wall";
  wall.shapes[0].geometry = HalfSpace{.normal = {1, 0}};
  Body light = box("light", {2.5, 0}, {1, 1}, elastic);
  Body heavy = box("heavy", {6.03, 0}, {1, 1}, surface(0, 1, std::pow(100, p.at("digits"))));
  heavy.velocity = {-speed, 0};
  scene.bodies = {wall, light, heavy};
  return scene;
}

// In the plane of sqrt(M) V and sqrt(m) v the energy is a circle and an impact turns it by a fixed angle, 2 q for each
// pair, tan q = sqrt(m/M) = 10^-digits: hence floor(pi 10^digits) impacts (Galperin). However late they are noticed,
// the state ends in the sector where the light block no longer catches up, 0 <= v <= V: there V lies between V0 cos q
// and V0. Every impact keeps the energy, whenever it comes; each
// sweep over one rounds the speeds.
std::vector<Expectation> expectations(const Parameters& p) {
  const double q = std::atan(std::pow(10, -p.at("digits")));
  const double impacts = std::pow(10, p.at("digits")) * 4;
  const double energy = mass_of(scene(p).bodies[2]).mass * speed * speed / 2;
  const auto exact = [=](const Stepping& s) {
    return round_off(s, duration, 10) + 4 * s.epsilon * impacts * (1 + s.iterations) * speed;
  };
  return {{.body = "heavy",
           .quantity = Quantity::vx,
           .expected = speed * (1 + std::cos(q)) / 2,
           .allowed = [=](const Stepping& s) { return speed * (1 - std::cos(q)) / 2 + exact(s); },
           .source = "V0 cos q <= V <= V0 in the last sector, tan q = sqrt(m/M)"},
          {.quantity = Quantity::energy,
           .allowed = [=](const Stepping& s) { return 2 * energy / speed * exact(s); },
           .source = "constant, as e = 1"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "pi-billiard",
     .question = "Do two blocks and a wall collide as often as pi has it?",
     .parameters =
         {{.name = "digits", .value = 1, .min = 0, .max = 3, .about = "of pi: mass ratio 100^digits", .whole = true}},
     .variants = {{"3", {{"digits", 0}}}, {"31", {}}, {"314", {{"digits", 2}}}},
     .closed_form = "line",
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::pi_billiard
