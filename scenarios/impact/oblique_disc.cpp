#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::oblique_disc {
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

// Jn = m (1+e) vn, Jt = min(mu Jn, m vt/3) against the slip vt: a disc's normal and tangential motion do not mix, and
// nothing changes before the impact. Noticed late, the disc overlaps by d = v lag and a gap, and the point of contact
// may be taken anywhere within: the arm is off by d. With o = d/r that changes
//   Jt of a grip, m (v + w r)/(1 + 2 (r_arm/r)^2), by m (4 vt + 3 w r)/9 o, hence along by (vt + w r) o/2 at most;
//   the spin by 2/r times that and Jt/m o <= vt o/3;                both up to (1 + o)^2 of higher terms.
// An impact slower than the threshold may be inelastic: e vn of speed is missing, and mu of it along the wall.
// Places are off by the jump times the lag, by these speeds times the time, and by the depth that may be put right.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double spin = std::abs(p.at("spin"));
  const double slip = v + spin * radius;
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, v + slip / radius + spin); };
  const auto overlap = [=](const Stepping& s) {
    const double o = (v * lag(s) + s.gap) / radius;
    return o * (1 + o) * (1 + o);
  };
  const double approach = v * std::cos(p.at("incidence") * degree);
  const double e = p.at("restitution");
  const double mu = p.at("friction");
  const auto dull = [=](const Stepping& s) { return approach < s.restitution_threshold ? e * approach : 0; };
  const auto along = [=](const Stepping& s) {
    return (slip + spin * radius) / 2 * overlap(s) + mu * dull(s) + exact(s);
  };
  const auto about = [=](const Stepping& s) { return 2 / radius * (along(s) + slip / 3 * overlap(s)); };
  const auto x = [=](const Stepping& s) { return slip / 3 * lag(s) + along(s) * duration; };
  const auto bounce = [=](const Stepping& s) { return dull(s) + exact(s); };
  const auto y = [=](const Stepping& s) { return 3 * v * lag(s) + s.gap + dull(s) * duration + exact(s); };
  const auto turn = [=](const Stepping& s) { return 2 * slip / (3 * radius) * lag(s) + about(s) * duration; };
  return {
      {.body = "disc",
       .quantity = Quantity::vx,
       .allowed = along,
       .source = "Jt = min(mu Jn, m vt/3); the arm's depth"},
      {.body = "disc", .quantity = Quantity::vy, .allowed = bounce, .source = "e vn, whenever it is noticed"},
      {.body = "disc", .quantity = Quantity::angular_velocity, .allowed = about, .source = "r Jt/I; the arm's depth"},
      {.body = "disc", .quantity = Quantity::x, .allowed = x, .source = "the jump times the lag"},
      {.body = "disc", .quantity = Quantity::y, .allowed = y, .source = "the jump times the lag, and the depth"},
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
     .variants = {{"slips", {}}, {"grips", {{"friction", 0.9}}}, {"grazes", {{"speed", 2}, {"incidence", 70}}}},
     .closed_form = "first-impact",
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::oblique_disc
