#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::mass_ratio {
namespace {

constexpr double duration = 5;  // s

std::string name(int k) { return "box " + std::to_string(k); }

// Each box `ratio` times as heavy as the one below it: the lightest carries all.
Scene scene(const Parameters& p) {
  Scene scene{.name = "mass-ratio", .about = "A tower in which heavy stands on light.", .duration = duration};
  scene.bodies.push_back(level_ground(surface(0.5, 0)));
  for (int k = 1; k <= static_cast<int>(p.at("boxes")); ++k) {
    const double density = std::pow(p.at("ratio"), k - 1);
    scene.bodies.push_back(box(name(k), {0, k - 0.5}, {1, 1}, surface(0.5, 0, density)));
  }
  return scene;
}

// The masses drop out: as in any tower, nothing moves but by one gap a contact below.
std::vector<Expectation> expectations(const Parameters& p) {
  std::vector<Expectation> all;
  for (int k = 1; k <= static_cast<int>(p.at("boxes")); ++k) {
    all.push_back({.body = name(k),
                   .quantity = Quantity::y,
                   .allowed = [=](const Stepping& s) { return k * s.gap + round_off(s, duration, k + 1); },
                   .source = "equilibrium: stays where it is, within one gap a contact below"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "mass-ratio",
     .question = "Does a tower stand whose boxes are ever heavier upwards?",
     .parameters = {{.name = "boxes", .value = 4, .min = 2, .max = 10, .about = "in the tower", .whole = true},
                    {.name = "ratio", .value = 10, .min = 1, .max = 100, .about = "mass of a box to the one below"}},
     .variants = {{"3", {{"ratio", 3}}}, {"10", {}}},
     .closed_form = "rest",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::mass_ratio
