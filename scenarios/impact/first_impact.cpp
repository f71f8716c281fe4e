#include <algorithm>
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

// The changes that the impact makes, by its lever arm: of velocity along the wall, m/s, and of spin, rad/s.
struct Change {
  double along = 0, about = 0;
};

// Jn = m (1+e) vn, Jt = min(mu Jn, m u/(1 + 2 arm^2/r^2)) against the slip velocity u = v + w arm: for a disc, normal
// and tangential motion are independent, and nothing changes before the impact.
struct Impact {
  double along, spin, approach, friction;

  Change with(double arm, double e) const {
    const double slip = along + spin * arm;
    const double stops = std::abs(slip) / (1 + 2 * arm * arm / (radius * radius));
    const double jump = std::copysign(std::min(friction * (1 + e) * approach, stops), -slip);
    return {jump, 2 * arm * jump / (radius * radius)};
  }
};

// An impact that is found late has let the disc in by vn lag, one that is found early has it a skin away, and its point
// may be taken anywhere between the two surfaces: the arm is off by at most d, the larger of both. What that changes
// follows from the law itself; where friction slips, the spin alone. A slop does not matter: contact is found at once.
// An impact slower than the threshold may be inelastic: e vn of normal velocity is missing, and friction is that of e =
// 0.
// Positions are off by the jump times the time by which the impact is found early or late, and by these errors for the
// rest of the run. Lifting the disc out of the wall only undoes some of being late.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double incidence = p.at("incidence") * degree;
  const double e = p.at("restitution");
  const Impact impact{v * std::sin(incidence), p.at("spin"), v * std::cos(incidence), p.at("friction")};
  const double approach = impact.approach;
  const Change jump = impact.with(radius, e);
  constexpr double after = duration / 2 + 0.01;  // s, from the impact to the end
  const auto exact = [=](const Stepping& s) {
    return round_off(s, duration, 2 * (v + std::abs(impact.spin) * (1 + radius)) / radius);
  };
  const auto slow = [=](const Stepping& s) { return approach < s.restitution_threshold; };
  const auto error = [=](const Stepping& s) {
    const double d = std::max(approach * lag(s), s.skin);
    Change worst;
    for (const double arm : {radius - d, radius - d / 2, radius, radius + d / 2, radius + d}) {
      for (const double bounce : {e, slow(s) ? 0 : e}) {
        const Change other = impact.with(arm, bounce);
        worst.along = std::max(worst.along, std::abs(other.along - jump.along));
        worst.about = std::max(worst.about, std::abs(other.about - jump.about));
      }
    }
    return worst;
  };
  const auto along = [=](const Stepping& s) { return error(s).along + exact(s); };
  const auto about = [=](const Stepping& s) { return error(s).about + exact(s); };
  const auto bounce = [=](const Stepping& s) { return (slow(s) ? e * approach : 0) + exact(s); };
  const auto x = [=](const Stepping& s) { return std::abs(jump.along) * found_off(s, approach) + along(s) * after; };
  const auto y = [=](const Stepping& s) {
    const double rests = e == 0 || slow(s) ? s.contact_gap() : 0;
    return (1 + e) * approach * found_off(s, approach) + rests + bounce(s) * after;
  };
  const auto turn = [=](const Stepping& s) { return std::abs(jump.about) * found_off(s, approach) + about(s) * after; };
  return {{.body = "disc",
           .quantity = Quantity::vx,
           .allowed = along,
           .source = "Jt = min(mu Jn, m vt/3); lever arm off by the penetration, if it sticks"},
          {.body = "disc", .quantity = Quantity::vy, .allowed = bounce, .source = "e vn, whenever it is detected"},
          {.body = "disc",
           .quantity = Quantity::angular_velocity,
           .allowed = about,
           .source = "r Jt/I; lever arm off by the penetration"},
          {.body = "disc", .quantity = Quantity::x, .allowed = x, .source = "the velocity jump times the lag"},
          {.body = "disc", .quantity = Quantity::y, .allowed = y, .source = "the velocity jump times the lag"},
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

constexpr double duration = 1;        // s
constexpr double found_early = 0.05;  // s, more than any skin takes at the slowest speed
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

// J = (1+e) m v/D, D = 1 + c^2 m/I, with the corner's horizontal distance c and I = m/6; without gravity or spin
// neither v nor c depends on when the impact is found. But an engine that finds it within its skin may first put that
// right: by turning the box by 6 c/D times the skin, which moves the corner sideways by its height below the centre
// times that. The jumps J/m and 6 c J/m follow from the law, at both ends of that interval. Positions are off by the
// jump times the time by which the impact is found early or late, and by its errors for the rest of the run. Lifting
// and turning the box out of the ground moves it as the impact does, so that it only undoes some of being late. A slop
// does not matter.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double e = p.at("restitution");
  const double tilt = p.at("tilt") * degree;
  const double level = std::abs(std::sin(tilt) - std::cos(tilt)) / 2;  // m, c
  const double below = (std::sin(tilt) + std::cos(tilt)) / 2;          // m
  const auto rise = [=](double c) { return (1 + e) * v / (1 + 6 * c * c); };
  const auto about = [=](double c) { return 6 * c * rise(c); };
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, off + about(level) + 2 * v); };
  const auto off_by = [=](const Stepping& s, const auto& jump) {
    const double aside = below * 6 * level / (1 + 6 * level * level) * s.skin;
    return std::max(std::abs(jump(level + aside) - jump(level)), std::abs(jump(level - aside) - jump(level))) +
           exact(s);
  };
  const double after = duration - std::max((off - below) / v - found_early, 0.0);  // s
  const auto up = [=](const Stepping& s) { return off_by(s, rise); };
  const auto spin = [=](const Stepping& s) { return off_by(s, about); };
  const auto height = [=](const Stepping& s) {
    const double rests = e == 0 || v < s.restitution_threshold ? s.contact_gap() : 0;
    return rise(level) * found_off(s, v) + rests + up(s) * after;
  };
  const auto turn = [=](const Stepping& s) { return about(level) * found_off(s, v) + spin(s) * after; };
  return {{.body = "box", .quantity = Quantity::vy, .allowed = up, .source = "J/m - v; lever arm within the skin"},
          {.body = "box",
           .quantity = Quantity::angular_velocity,
           .allowed = spin,
           .source = "r x J/I; lever arm within the skin"},
          {.body = "box", .quantity = Quantity::y, .allowed = height, .source = "the velocity jump times the lag"},
          {.body = "box", .quantity = Quantity::angle, .allowed = turn, .source = "the velocity jump times the lag"}};
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
