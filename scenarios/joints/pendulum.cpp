#include "scenarios/joints/hinged_rod.h"
#include "scenarios/parts.h"

namespace plumb::scenarios::pendulum {
namespace {

constexpr double duration = 3;  // s

Scene scene(const Parameters& p) {
  Scene scene = hinged_rod(p.at("length"), p.at("angle") * degree, duration);
  scene.name = "pendulum";
  scene.about = "A rod swings on a frictionless pivot.";
  return scene;
}

std::vector<Expectation> expectations(const Parameters& p) {
  return hinged_rod_expectations(p.at("length"), p.at("angle") * degree, duration);
}

const Catalog<Scenario>::Entry entry{
    {.name = "pendulum",
     .question = "Does a pendulum's period grow with its swing as the elliptic integral says?",
     .parameters =
         {{.name = "length", .value = 2, .min = 0.5, .max = 10, .unit = "m", .about = "of the rod"},
          {.name = "angle", .value = 90, .min = -90, .max = 90, .unit = "deg", .about = "let go at, from below"}},
     .variants = {{"small", {{"angle", 10}}}, {"wide", {}}},
     .closed_form = "pendulum",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::pendulum
