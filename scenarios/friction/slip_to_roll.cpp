#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::slip_to_roll {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double radius = 0.5;  // m

Scene scene(const Parameters& p) {
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "slip-to-roll",
              .about = "A disc thrown along the ground without spin, like a bowling ball.",
              .gravity = {0, -gravity},
              .duration = std::ceil(p.at("speed") / (3 * p.at("friction") * gravity)) + 1};
  scene.bodies.push_back(level_ground(rough));
  Body ball = disc("disc", {0, radius}, radius, rough);
  ball.velocity = {p.at("speed"), 0};
  scene.bodies.push_back(ball);
  return scene;
}

// Friction has no moment about a point of the ground, so the disc ends with 2 v/3 whatever friction did when. Only the
// arm matters: a contact point off by the gap makes it v/(1 + r^2/(2 arm^2)), by 4/9 v gap/r. The way depends on more:
// friction a lag late leaves it v/3 too fast for so long, and drifts over the loss of v/3.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double end = scene(p).duration;
  const auto speed = [=](const Stepping& s) { return s.creep + v * s.gap / radius + round_off(s, end, v); };
  const auto spin = [=](const Stepping& s) { return 2 * speed(s) / radius; };
  const auto place = [=](const Stepping& s) {
    return v / 3 * (lag(s) + std::abs(s.drift) * s.h) + speed(s) * end + round_off(s, end, v * end);
  };
  const auto turn = [=](const Stepping& s) { return 2 * place(s) / radius; };
  return {{.body = "disc",
           .quantity = Quantity::vx,
           .allowed = speed,
           .source = "2 v/3, whatever friction did when; the arm off by the gap"},
          {.body = "disc", .quantity = Quantity::angular_velocity, .allowed = spin, .source = "-2 v/(3 r)"},
          {.body = "disc",
           .quantity = Quantity::x,
           .allowed = place,
           .source = "rolls after v/(3 mu g); a lag late, drift"},
          {.body = "disc", .quantity = Quantity::angle, .allowed = turn, .source = "rolls after v/(3 mu g)"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "slip-to-roll",
     .question = "Does a disc thrown without spin end up rolling with two thirds of its speed?",
     .parameters = {{.name = "speed", .value = 6, .min = 0.5, .max = 30, .unit = "m/s", .about = "at the start"},
                    {.name = "friction", .value = 0.3, .min = 0.05, .max = 2, .about = "of disc and ground"}},
     .variants = {{"mu=0.3", {}}, {"mu=0.1", {{"friction", 0.1}}}},
     .closed_form = "roll",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::slip_to_roll
