#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/friction/leaning_ladder.h"
#include "scenarios/parts.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::ladder {
namespace {

constexpr double duration = 1;  // s

Scene scene(const Parameters& p) {
  Scene scene = leaning_ladder(p.at("angle") * degree, p.at("friction"), duration);
  scene.name = "ladder";
  scene.about = "A ladder leans on a smooth wall.";
  return scene;
}

// Standing, the floor carries m g and the wall m g/(2 tan a), whatever the ladder did before: what the contacts gave in
// all is the weight times the time, less what a lag at the start and the last step may lack.
std::vector<Expectation> expectations(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  std::vector<Expectation> all = leaning_ladder_expectations(angle, p.at("friction"), duration);
  if (2 * p.at("friction") * std::tan(angle) < 1) return all;
  const Scene asked = scene(p);
  const double weight = mass_of(asked.bodies[2]).mass * -asked.gravity.y;
  const auto lacking = [=](const Stepping& s) {
    return weight * (lag(s) + s.h) / duration + weight * s.gap / ladder_half() + round_off(s, duration, weight);
  };
  all.push_back({.body = "ladder",
                 .other = "ground",
                 .quantity = Quantity::load,
                 .over = duration,
                 .expected = weight,
                 .allowed = lacking,
                 .source = "m g, in the mean; a lag at the start and the last step"});
  all.push_back({.body = "ladder",
                 .other = "wall",
                 .quantity = Quantity::load,
                 .over = duration,
                 .expected = weight / (2 * std::tan(angle)),
                 .allowed = lacking,
                 .source = "m g/(2 tan a), in the mean; a lag at the start and the last step"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "ladder",
     .question = "Does a ladder on a smooth wall stand iff tan a >= 1/(2 mu)?",
     .parameters = {{.name = "angle", .value = 48, .min = 20, .max = 80, .unit = "deg", .about = "above the level"},
                    {.name = "friction", .value = 0.5, .min = 0, .max = 0.9, .about = "of ladder and floor"}},
     .variants = {{"stands", {}}, {"slides", {{"angle", 38}}}},
     .closed_form = "ladder",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::ladder
