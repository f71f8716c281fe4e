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
              .about = "A spinning disc hits a wall at an angle, without gravity.",
              .gravity = {0, 0},
              .duration = duration};
  scene.bodies.push_back(level_ground(felt));
  // It touches the wall halfway through the run.
  const double v = p.at("speed");
  const Vec velocity{v * std::sin(down), -v * std::cos(down)};
  Body ball = disc("disc", {0, radius - velocity.y * (duration / 2 - 0.01)}, radius, felt);
  ball.velocity = velocity;
  ball.angular_velocity = p.at("spin");
  scene.bodies.push_back(ball);
  return scene;
}

// Jn = m (1+e) vn, Jt = min(mu Jn, m vt/3) against the slip velocity vt: for a disc, normal and tangential motion are
// independent, and nothing changes before the impact. If the impact is detected late the disc penetrates by d = v lag +
// gap, and the contact point may be taken anywhere within d, so the lever arm is off by d. With o = d/r that changes
//   Jt of a sticking impact, m (v + w r)/(1 + 2 (r_arm/r)^2), by m (4 vt + 3 w r)/9 o, hence the tangential velocity by
//     at most (vt + w r) o/2;
//   the spin by 2/r times that plus Jt/m o <= vt o/3; both up to higher terms, a factor of (1 + o)^2.
// An impact slower than the threshold may be inelastic: e vn of normal velocity is missing, and mu times that along the
// wall. Positions are off by the velocity jump times the lag, by these velocity errors times the time, and by the
// penetration that may be corrected.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double spin = std::abs(p.at("spin"));
  const double slip = v + spin * radius;
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, v + slip / radius + spin); };
  const auto overlap = [=](const Stepping& s) {
    const double o = (v * lag(s) + s.contact_gap()) / radius;
    return o * (1 + o) * (1 + o);
  };
  const double approach = v * std::cos(p.at("incidence") * degree);
  const double e = p.at("restitution");
  const double mu = p.at("friction");
  const auto inelastic = [=](const Stepping& s) { return approach < s.restitution_threshold ? e * approach : 0; };
  const auto along = [=](const Stepping& s) {
    return (slip + spin * radius) / 2 * overlap(s) + mu * inelastic(s) + exact(s);
  };
  const auto about = [=](const Stepping& s) { return 2 / radius * (along(s) + slip / 3 * overlap(s)); };
  const auto x = [=](const Stepping& s) { return slip / 3 * lag(s) + along(s) * duration; };
  const auto bounce = [=](const Stepping& s) { return inelastic(s) + exact(s); };
  const auto y = [=](const Stepping& s) {
    return 3 * v * lag(s) + s.contact_gap() + inelastic(s) * duration + exact(s);
  };
  const auto turn = [=](const Stepping& s) { return 2 * slip / (3 * radius) * lag(s) + about(s) * duration; };
  return {{.body = "disc",
           .quantity = Quantity::vx,
           .allowed = along,
           .source = "Jt = min(mu Jn, m vt/3); lever arm off by the penetration"},
          {.body = "disc", .quantity = Quantity::vy, .allowed = bounce, .source = "e vn, whenever it is detected"},
          {.body = "disc",
           .quantity = Quantity::angular_velocity,
           .allowed = about,
           .source = "r Jt/I; lever arm off by the penetration"},
          {.body = "disc", .quantity = Quantity::x, .allowed = x, .source = "the velocity jump times the lag"},
          {.body = "disc",
           .quantity = Quantity::y,
           .allowed = y,
           .source = "the velocity jump times the lag, and the penetration"},
          {.body = "disc", .quantity = Quantity::angle, .allowed = turn, .source = "the velocity jump times the lag"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "oblique-disc",
     .question = "Does a disc leave a wall with the velocity and spin that friction gives it?",
     .parameters =
         {{.name = "speed", .value = 6, .min = 2, .max = 50, .unit = "m/s", .about = "of the centre"},
          {.name = "incidence", .value = 45, .min = 0, .max = 70, .unit = "deg", .about = "angle from the normal"},
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

namespace plumb::scenarios::corner_impact {
namespace {

constexpr double duration = 1;  // s
constexpr double off = 1.7;  // m, height of the centre at the start: the corner lands in mid-run at the default speed

Scene scene(const Parameters& p) {
  const Surface bouncy = surface(0, p.at("restitution"));
  Scene scene{.name = "corner-impact",
              .about = "A tilted box hits the ground with one corner, without friction or gravity.",
              .gravity = {0, 0},
              .duration = duration};
  scene.bodies.push_back(level_ground(bouncy));
  Body falling = box("box", {0, off}, {1, 1}, bouncy);
  falling.angle = p.at("tilt") * degree;
  falling.velocity = {0, -p.at("speed")};
  scene.bodies.push_back(falling);
  return scene;
}

// J = (1+e) m v/(1 + (r x n)^2 m/I); without gravity or spin neither v nor r depends on when the impact is detected. An
// engine may take the contact point anywhere within its gap: with c = r x n and I = m/6, d(J/m)/dc is at most 1.6 (1+e)
// v (1/m) and d(c J/I)/dc at most 6 (1+e) v. Positions are off by the velocity jump times the lag, and by the
// penetration that may be corrected: upwards, and in angle by at most 3 r_x/R^2 times it (r_x <= R, R^2 = 1/2 for this
// box).
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double e = p.at("restitution");
  const double radius = std::sqrt(0.5);
  const double spin = 6 * radius * (1 + e) * v;  // rad/s at most: r J/I with J <= (1+e) m v, I = m/6
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, off + spin); };
  const auto rise = [=](const Stepping& s) { return 1.6 * (1 + e) * v * s.contact_gap() + exact(s); };
  const auto about = [=](const Stepping& s) { return 6 * (1 + e) * v * s.contact_gap() + exact(s); };
  const auto height = [=](const Stepping& s) { return (2 + e) * v * lag(s) + s.contact_gap() + exact(s); };
  const auto turn = [=](const Stepping& s) {
    return (spin + 3 * v / radius) * lag(s) + 3 * s.contact_gap() / radius + exact(s);
  };
  return {{.body = "box", .quantity = Quantity::vy, .allowed = rise, .source = "J/m - v; lever arm within the gap"},
          {.body = "box",
           .quantity = Quantity::angular_velocity,
           .allowed = about,
           .source = "r x J/I; lever arm within the gap"},
          {.body = "box",
           .quantity = Quantity::y,
           .allowed = height,
           .source = "the velocity jump times the lag, and the penetration"},
          {.body = "box",
           .quantity = Quantity::angle,
           .allowed = turn,
           .source = "the velocity jump times the lag, and the penetration"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "corner-impact",
     .question = "Does a box that lands on a corner get the right spin?",
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
