#include "scenarios/joints/hinged_rod.h"
#include "scenarios/parts.h"

namespace plumb::scenarios::rod_toppling {
namespace {

constexpr double duration = 1;  // s, after which a rod of 4 m is about level

double from_below(const Parameters& p) { return (180 - p.at("lean")) * degree; }

Scene scene(const Parameters& p) {
  Scene scene = hinged_rod(p.at("length"), from_below(p), duration);
  scene.name = "rod-toppling";
  scene.about = "A rod that stands on a pivot topples.";
  return scene;
}

std::vector<Expectation> expectations(const Parameters& p) {
  return hinged_rod_expectations(p.at("length"), from_below(p), duration);
}

const Catalog<Scenario>::Entry entry{
    {.name = "rod-toppling",
     .question = "Does a toppling rod turn with w^2 = (3 g/L)(cos b0 - cos b)?",
     .parameters =
         {{.name = "length", .value = 4, .min = 1, .max = 20, .unit = "m", .about = "of the rod"},
          {.name = "lean", .value = 15, .min = 1, .max = 80, .unit = "deg", .about = "let go at, from upright"}},
     .variants = {{"15deg", {}}},
     .closed_form = "pendulum",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::rod_toppling
