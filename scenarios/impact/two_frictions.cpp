#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::two_frictions {
namespace {

constexpr double duration = 1;  // s
constexpr double radius = 0.5;  // m
constexpr double apart = 0.97;  // m from the ground at the start

Scene scene(const Parameters& p) {
  Surface rough = surface(p.at("dynamic"), p.at("restitution"));
  rough.static_friction = p.at("static");
  Scene scene{
      .name = "two-frictions",
      .about = "A disc hits rough ground at an angle, without gravity; sticking friction exceeds sliding friction.",
      .gravity = {0, 0},
      .duration = duration};
  scene.bodies.push_back(level_ground(rough));
  Body ball = disc("disc", {0, radius + apart}, radius, rough);
  ball.velocity = {p.at("along"), -p.at("speed")};
  scene.bodies.push_back(ball);
  return scene;
}

// The point that touches slips with u = along until friction has stopped it, and while it slips the sliding coefficient
// acts: Jt = min(mu_d Jn, m u/3), Jn = m (1+e) v, as 1/m + r^2/I = 3/m for a disc. Once it sticks nothing asks for
// friction, so that the sticking coefficient does not matter at all. Nothing before the impact changes these
// velocities, and an arm that is off by the penetration, v lag, and the gap, o = that/r, changes the friction of a disc
// that sticks by at most its share o.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double u = p.at("along");
  const double e = p.at("restitution");
  const double friction = std::min(p.at("dynamic") * (1 + e) * v, u / 3);  // m/s: Jt/m
  const double after = duration - apart / v;                               // s
  const double spin = -2 * friction / radius;
  const double reach = 2 * radius + (u + v) * duration + std::abs(spin);
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, reach); };
  const auto overlap = [=](const Stepping& s) { return (v * lag(s) + s.contact_gap()) / radius; };
  const auto along = [=](const Stepping& s) { return friction * overlap(s) + exact(s); };
  const auto about = [=](const Stepping& s) { return 2 * std::abs(spin) * overlap(s) + exact(s); };
  const auto place = [=](const Stepping& s) { return friction * lag(s) + along(s) * after + exact(s); };
  const auto turn = [=](const Stepping& s) { return std::abs(spin) * lag(s) + about(s) * after + exact(s); };
  return {
      {.body = "disc",
       .quantity = Quantity::vx,
       .expected = u - friction,
       .allowed = along,
       .source = "Jt = min(mu_d Jn, m u/3)"},
      {.body = "disc", .quantity = Quantity::vy, .expected = e * v, .allowed = exact, .source = "e v"},
      {.body = "disc", .quantity = Quantity::angular_velocity, .expected = spin, .allowed = about, .source = "r Jt/I"},
      {.body = "disc",
       .quantity = Quantity::x,
       .expected = u * duration - friction * after,
       .allowed = place,
       .source = "the velocity jump times the lag"},
      {.body = "disc",
       .quantity = Quantity::angle,
       .expected = spin * after,
       .allowed = turn,
       .source = "the velocity jump times the lag"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "two-frictions",
     .question = "Does a slipping impact use the friction of sliding, not that of sticking?",
     .parameters =
         {{.name = "static", .value = 0.8, .min = 0.5, .max = 2, .about = "coefficient of friction while sticking"},
          {.name = "dynamic", .value = 0.2, .min = 0, .max = 0.5, .about = "coefficient of friction while sliding"},
          {.name = "along", .value = 5, .min = 0, .max = 20, .unit = "m/s", .about = "velocity along the ground"},
          {.name = "speed", .value = 2, .min = 1.5, .max = 20, .unit = "m/s", .about = "of the approach"},
          {.name = "restitution", .value = 0.6, .min = 0, .max = 1, .about = "of disc and ground"}},
     .variants = {{"slips", {}}, {"grips", {{"along", 1.5}}}},
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::two_frictions
