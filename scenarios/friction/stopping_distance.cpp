#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::stopping_distance {
namespace {

constexpr double gravity = 10;  // m/s^2
const Vec size{1, 0.5};         // m; low enough not to tip: mu < b/h = 2

double stop(const Parameters& p) { return p.at("speed") / (p.at("friction") * gravity); }

Scene scene(const Parameters& p) {
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "stopping-distance",
              .about = "A box slides over level ground until friction has stopped it.",
              .gravity = {0, -gravity},
              .duration = std::ceil(stop(p)) + 1};
  scene.bodies.push_back(level_ground(rough));
  Body sliding = box("box", {0, size.y / 2}, size, rough);
  sliding.velocity = {p.at("speed"), 0};
  scene.bodies.push_back(sliding);
  return scene;
}

// It stops after v/(mu g) at v^2/(2 mu g). Friction that starts a lag late lets it go on at v for that long; the drift
// of the decelerated way is drift (mu g) (v/(mu g)) h. A method that knows of no moment within a step
//
//   takes the step in which it stops whole: with u of it left until the stop, friction of the whole step in the way is
//   mu g h^2 (1 - u)^2/2 too much, and given again in the next, until it is seen to push what stands, u mu g h^2/2:
//   together less than mu g h^2/2;
//   and lets the box sink by the gap: by mu of that friction is late; braked it leans, one end in by the gap, which
//   moves its centre at half the height by gap (height/length).
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double end = scene(p).duration;
  const double reach = v * v / (2 * p.at("friction") * gravity) + v * end;
  const double mu = p.at("friction");
  const auto place = [=](const Stepping& s) {
    return v * (lag(s) + std::abs(s.drift) * s.h) + mu * gravity * s.h * s.h / 2 + (mu + size.y / size.x) * s.gap +
           s.creep * end + round_off(s, end, reach);
  };
  const auto speed = [=](const Stepping& s) { return s.creep + round_off(s, end, v); };
  return {
      {.body = "box",
       .quantity = Quantity::x,
       .allowed = place,
       .source = "v^2/(2 mu g); friction a lag late, drift, the step of the stop, sinking"},
      {.body = "box", .quantity = Quantity::speed, .allowed = speed, .source = "stopped after v/(mu g); may creep"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "stopping-distance",
     .question = "Does a sliding box stop where Coulomb's friction has used up its energy?",
     .parameters = {{.name = "speed", .value = 5, .min = 0.1, .max = 20, .unit = "m/s", .about = "at the start"},
                    {.name = "friction", .value = 0.3, .min = 0.1, .max = 1.5, .about = "of box and ground"}},
     .variants = {{"mu=0.3", {}}, {"mu=0.8", {{"friction", 0.8}}}},
     .closed_form = "slide",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::stopping_distance
