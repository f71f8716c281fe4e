#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb {
namespace {

constexpr double duration = 1;  // s
constexpr double radius = 0.5;  // m

Scene scene(const Parameters& p) {
  const Surface felt = surface(p.at("friction"), p.at("restitution"));
  const double down = p.at("incidence") * degree;
  Scene scene{.name = "oblique-disc",
              .about = "A disc with spin meets a wall at an angle, without gravity.",
              .gravity = {0, 0},
              .duration = duration};
  scene.bodies.push_back(level_ground(felt));
  // Halfway through the run it touches the wall.
  const double v = p.at("speed");
  const Vec velocity{v * std::sin(down), -v * std::cos(down)};
  Body ball = disc("disc", {0, radius - velocity.y * (duration / 2 - 0.01)}, radius, felt);
  ball.velocity = velocity;
  ball.angular_velocity = p.at("spin");
  scene.bodies.push_back(ball);
  return scene;
}

// Jn = m (1+e) vn, Jt = min(mu Jn, m vt/3) against the slip vt: a disc's normal and tangential motion do not mix.
// Nothing changes before the impact, so that the speeds do not care when it is noticed; places are off by their jump
// times the lag, and by the depth that may be put right.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double spin = std::abs(p.at("spin"));
  const double slip = v + spin * radius;
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, v + slip / radius + spin); };
  const auto place = [=](const Stepping& s) { return (2 * v + v) * lag(s) + s.gap + exact(s); };
  const auto along = [=](const Stepping& s) { return slip / 3 * lag(s) + exact(s); };
  const auto turn = [=](const Stepping& s) { return 2 * slip / (3 * radius) * lag(s) + exact(s); };
  return {
      {.body = "disc", .quantity = Quantity::vx, .allowed = exact, .source = "Jt = min(mu Jn, m vt/3)"},
      {.body = "disc", .quantity = Quantity::vy, .allowed = exact, .source = "e vn"},
      {.body = "disc", .quantity = Quantity::angular_velocity, .allowed = exact, .source = "r Jt/I"},
      {.body = "disc", .quantity = Quantity::x, .allowed = along, .source = "the jump times the lag"},
      {.body = "disc", .quantity = Quantity::y, .allowed = place, .source = "the jump times the lag, and the depth"},
      {.body = "disc", .quantity = Quantity::angle, .allowed = turn, .source = "the jump times the lag"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "oblique-disc",
     .question = "Does a disc leave a wall with the speed and spin that friction gives it?",
     .parameters =
         {{.name = "speed", .value = 6, .min = 2, .max = 50, .unit = "m/s", .about = "of the centre"},
          {.name = "incidence", .value = 45, .min = 0, .max = 70, .unit = "deg", .about = "against the normal"},
          {.name = "spin", .value = 2, .min = -50, .max = 50, .unit = "rad/s", .about = "before the impact"},
          {.name = "friction", .value = 0.1, .min = 0, .max = 2, .about = "of disc and wall"},
          {.name = "restitution", .value = 0.6, .min = 0, .max = 1, .about = "of disc and wall"}},
     .variants = {{"slips", {}}, {"grips", {{"friction", 0.9}}}},
     .closed_form = "first-impact",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb
