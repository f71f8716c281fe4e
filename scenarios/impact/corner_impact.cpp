#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::corner_impact {
namespace {

constexpr double duration = 1;  // s
constexpr double off = 1.7;     // m, of the centre at the start: the corner lands in mid-run at the default speed

Scene scene(const Parameters& p) {
  const Surface bouncy = surface(0, p.at("restitution"));
  Scene scene{.name = "corner-impact",
              .about = "A tilted box meets the ground with one corner, without friction or gravity.",
              .gravity = {0, 0},
              .duration = duration};
  scene.bodies.push_back(level_ground(bouncy));
  Body falling = box("box", {0, off}, {1, 1}, bouncy);
  falling.angle = p.at("tilt") * degree;
  falling.velocity = {0, -p.at("speed")};
  scene.bodies.push_back(falling);
  return scene;
}

// J = (1+e) m v/(1 + (r x n)^2 m/I); without gravity or spin neither v nor r depends on when the impact is noticed. An
// engine may take the point of contact anywhere within its gap: with c = r x n and I = m/6, d(J/m)/dc is at most 1.6
// (1+e) v (1/m) and d(c J/I)/dc at most 6 (1+e) v. Places are off by the jump times the lag, and by what the corner
// sank in meanwhile and may be put right: upwards, and about by at most 3 r_x/R^2 of it (r_x <= R, R^2 = 1/2 for this
// box).
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double e = p.at("restitution");
  const double radius = std::sqrt(0.5);
  const double spin = 6 * radius * (1 + e) * v;  // rad/s at most: r J/I with J <= (1+e) m v, I = m/6
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, off + spin); };
  const auto rise = [=](const Stepping& s) { return 1.6 * (1 + e) * v * s.gap + exact(s); };
  const auto about = [=](const Stepping& s) { return 6 * (1 + e) * v * s.gap + exact(s); };
  const auto height = [=](const Stepping& s) { return (2 + e) * v * lag(s) + s.gap + exact(s); };
  const auto turn = [=](const Stepping& s) { return (spin + 3 * v / radius) * lag(s) + 3 * s.gap / radius + exact(s); };
  return {
      {.body = "box", .quantity = Quantity::vy, .allowed = rise, .source = "J/m - v; the arm within a gap"},
      {.body = "box",
       .quantity = Quantity::angular_velocity,
       .allowed = about,
       .source = "r x J/I; the arm within a gap"},
      {.body = "box", .quantity = Quantity::y, .allowed = height, .source = "the jump times the lag, and the depth"},
      {.body = "box", .quantity = Quantity::angle, .allowed = turn, .source = "the jump times the lag, and the depth"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "corner-impact",
     .question = "Does a box that lands on a corner take the right spin from it?",
     .parameters = {{.name = "tilt", .value = 30, .min = 5, .max = 85, .unit = "deg", .about = "of the box"},
                    {.name = "speed", .value = 2, .min = 2, .max = 20, .unit = "m/s", .about = "of the approach"},
                    {.name = "restitution", .value = 0.8, .min = 0, .max = 1, .about = "of box and ground"}},
     .variants = {{"e=0.8", {}}, {"e=1", {{"restitution", 1}}}},
     .closed_form = "first-impact",
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::corner_impact
