#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::overhang {
namespace {

constexpr double friction = 0.5;
constexpr double duration = 5;  // s
const Vec block{2, 0.5};        // m

std::string name(int k) { return "block " + std::to_string(k); }

// Counted from the top, block k reaches fraction * L/(2 k) beyond the next; the lowest lies on the ground.
Scene scene(const Parameters& p) {
  const int blocks = static_cast<int>(p.at("blocks"));
  Scene scene{.name = "overhang", .about = "Blocks stepped out to the harmonic limit.", .duration = duration};
  scene.bodies.push_back(level_ground(surface(friction, 0)));
  double x = 0;
  for (int k = blocks; k >= 1; --k) {
    scene.bodies.push_back(box(name(k), {x, (blocks - k + 0.5) * block.y}, block, surface(friction, 0)));
    if (k > 1) x += p.at("fraction") * block.x / (2 * (k - 1));
  }
  return scene;
}

// Beyond the limit the blocks above each surface have their centre beyond its edge, and turn about it. In the end the
// top block has come down by its own height at least: any rest there is has it off the pile.
std::vector<Expectation> fallen(int blocks) {
  return {{.body = name(1),
           .quantity = Quantity::y,
           .relation = Relation::at_most,
           .expected = (blocks - 1.5) * block.y,
           .allowed = [=](const Stepping& s) { return round_off(s, duration, block.x * blocks); },
           .source = "topples: overhang above (L/2) sum 1/k; down by a block at least"}};
}

// Below it nothing moves: within a gap a contact below in height, and what those gaps tilt, 2 gap/bearing each, where
// the bearing is what is left of L under block k: L (1 - fraction/(2 k)) at least half of it.
std::vector<Expectation> expectations(const Parameters& p) {
  const int blocks = static_cast<int>(p.at("blocks"));
  if (p.at("fraction") > 1) return fallen(blocks);
  std::vector<Expectation> all;
  for (int k = 1; k <= blocks; ++k) {
    const int below = blocks - k + 1;
    const double tilt = 4.0 * below / block.x;  // rad per m of gap
    all.push_back({.body = name(k),
                   .quantity = Quantity::y,
                   .allowed =
                       [=](const Stepping& s) {
                         return (below + tilt * block.x / 2 * below) * s.gap + round_off(s, duration, block.x * blocks);
                       },
                   .source = "equilibrium: overhang below (L/2) sum 1/k; a gap a contact below, and their tilt"});
    all.push_back({.body = name(k),
                   .quantity = Quantity::angle,
                   .allowed = [=](const Stepping& s) { return tilt * s.gap + round_off(s, duration, 1); },
                   .source = "equilibrium: the tilt of a gap a contact below"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "overhang",
     .question = "Do blocks stepped out to the harmonic series stand, and fall beyond it?",
     .parameters = {{.name = "blocks", .value = 4, .min = 2, .max = 20, .about = "in the pile", .whole = true},
                    {.name = "fraction", .value = 0.99, .min = 0, .max = 1.5, .about = "of the limit"}},
     .variants = {{"90%", {{"fraction", 0.9}}}, {"99%", {}}, {"101%", {{"fraction", 1.01}}}},
     .closed_form = "rest",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::overhang
