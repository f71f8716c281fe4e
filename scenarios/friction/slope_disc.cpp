#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::slope_disc {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 2;  // s

Scene scene(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const double radius = p.at("radius");
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "slope-disc", .about = "A disc on a slope.", .gravity = {0, -gravity}, .duration = duration};
  scene.bodies.push_back(level_ground(rough));
  scene.bodies[0].angle = angle;
  scene.bodies.push_back(disc("disc", {-radius * std::sin(angle), radius * std::cos(angle)}, radius, rough));
  return scene;
}

// Rolls with (2/3) g sin a iff mu >= tan(a)/3, else slips with g (sin a - mu cos a) and spins up with 2 mu g cos(a)/r.
// The contact may be noticed a lag late: friction, at most mu g cos a and never more than the g sin a that it opposes,
// is missing so long; rolling makes that good, slipping does not. While it sinks by the gap at a speed of u, the
// contact has given m u less, and slipping friction mu of that less: a turn of 2 mu gap/r is missing.
std::vector<Expectation> expectations(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const double mu = p.at("friction");
  const double radius = p.at("radius");
  const bool rolls = mu >= std::tan(angle) / 3;
  const double friction = rolls ? gravity * std::sin(angle) / 3 : mu * gravity * std::cos(angle);
  const double acceleration = gravity * std::sin(angle) - friction;
  const double reach = radius + gravity * duration * duration;
  const auto speed = [=](const Stepping& s) { return friction * lag(s) + s.creep + round_off(s, duration, reach); };
  const auto place = [=](const Stepping& s) {
    return speed(s) * duration + drifted(s, acceleration, duration) + s.gap + gravity * std::sin(angle) * lag(s) * s.h;
  };
  const auto spin = [=](const Stepping& s) { return 2 * speed(s) / radius; };
  const auto turn = [=](const Stepping& s) {
    return spin(s) * duration + 2 * (drifted(s, friction, duration) + (rolls ? 0 : mu * s.gap)) / radius;
  };
  const std::string law = rolls ? "(2/3) g sin a t" : "g (sin a - mu cos a) t";
  return {
      {.body = "disc", .quantity = Quantity::speed, .allowed = speed, .source = law + "; friction a lag late"},
      {.body = "disc", .quantity = Quantity::x, .allowed = place, .source = law + "; friction a lag late, drift, gap"},
      {.body = "disc", .quantity = Quantity::y, .allowed = place, .source = law + "; friction a lag late, drift, gap"},
      {.body = "disc", .quantity = Quantity::angular_velocity, .allowed = spin, .source = "2 f t/r"},
      {.body = "disc", .quantity = Quantity::angle, .allowed = turn, .source = "f t^2/r"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "slope-disc",
     .question =
         "Does a disc roll down a slope with two thirds of a slider's pull, and slip where friction is too weak?",
     .parameters = {{.name = "angle", .value = 20, .min = 1, .max = 60, .unit = "deg", .about = "of the slope"},
                    {.name = "friction", .value = 0.5, .min = 0, .max = 2, .about = "of disc and slope"},
                    {.name = "radius", .value = 0.5, .min = 0.1, .max = 2, .unit = "m", .about = "of the disc"}},
     .variants = {{"rolls", {}}, {"slips", {{"angle", 40}, {"friction", 0.1}}}},
     .closed_form = "roll",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::slope_disc
