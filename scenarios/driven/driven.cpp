#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

// Mechanisms that a kinematic body drives at constant speed.
namespace plumb::scenarios::slider_crank {
namespace {

constexpr double crank = 0.5;     // m, from the shaft to the crank's pin
constexpr double rod = 1.6;       // m, from pin to pin
constexpr double at_start = 0.3;  // rad, of the crank
constexpr double duration = 3;    // s

struct Pose {
  double along, speed;    // m, m/s, of the piston from the shaft
  double tilt, turning;   // rad, rad/s, of the rod, from the pin of the crank to that of the piston
  Vec pin, pin_velocity;  // m, m/s
};

// x = r cos a + sqrt(l^2 - r^2 sin^2 a) (Reuleaux, Theoretische Kinematik, 1875).
Pose pose(double turn, double t) {
  const double angle = at_start + turn * t;
  const Vec pin{crank * std::cos(angle), crank * std::sin(angle)};
  const Vec pin_velocity{-turn * pin.y, turn * pin.x};
  const double across = std::sqrt(rod * rod - pin.y * pin.y);
  const double turning = -pin_velocity.y / across;
  return {pin.x + across, pin_velocity.x + turning * pin.y, std::asin(-pin.y / rod), turning, pin, pin_velocity};
}

Scene scene(const Parameters& p) {
  const double turn = p.at("turn");
  const Pose start = pose(turn, 0);
  Scene scene{.name = "slider-crank",
              .about = "A crank that turns regardless drives a piston.",
              .gravity = {0, 0},
              .duration = duration};
  Body shaft = box("crank", {0, 0}, {2 * crank, 0.2}, {});
  shaft.type = BodyType::kinematic;
  shaft.angle = at_start;
  shaft.angular_velocity = turn;
  Body link = box("rod", {(start.pin.x + start.along) / 2, start.pin.y / 2}, {rod, 0.1}, {});
  link.angle = start.tilt;
  link.angular_velocity = start.turning;
  link.velocity = {(start.pin_velocity.x + start.speed) / 2, start.pin_velocity.y / 2};
  Body piston = box("piston", {start.along, 0}, {0.5, 0.5}, {});
  piston.velocity = {start.speed, 0};
  scene.bodies = {shaft, link, piston, {.name = "cylinder", .type = BodyType::fixed}};
  for (Body& body : scene.bodies) body.layers = 0;
  scene.joints = {Revolute{.a = 0, .b = 1, .anchor = start.pin}, Revolute{.a = 1, .b = 2, .anchor = {start.along, 0}},
                  Prismatic{.a = 3, .b = 2, .anchor = {start.along, 0}}};
  return scene;
}

// The crank's angle decides all else. Each of the three joints may be off by the slop and, for methods of first order
// that hold joints by velocities alone, by what its pins turn away from their tangents in a step, (W h)^2 r/2, and
// corrections of a tenth a step leave ten times that (Baumgarte). Across the rod that counts 1/cos of its tilt.
//   Speed   first order: the joints' velocities are those of the step's start, up to the largest acceleration, r W^2
//           (1 + r/l), times a step; second order: (W h)^2/3 of it.
std::vector<Expectation> expectations(const Parameters& p) {
  const double turn = p.at("turn");
  const double steepest = rod / std::sqrt(rod * rod - crank * crank);  // 1/cos of the largest tilt
  const auto off = [=](const Stepping& s) {
    const double step = turn * s.h;
    const double left = first_order(s) ? 10 * step * step * crank / 2 : 0;
    return 3 * steepest * (s.joint_slop + left) + round_off(s, duration, 2 * (crank + rod) + turn * crank * duration);
  };
  const auto speed = [=](const Stepping& s) {
    const double step = turn * s.h;
    const double share = first_order(s) ? step : step * step / 3;
    return crank * turn * (1 + crank / rod) * share + turn * off(s);
  };
  std::vector<Expectation> all;
  for (const double t : {duration / 2, duration}) {
    const Pose at = pose(turn, t);
    all.push_back({.body = "piston",
                   .quantity = Quantity::x,
                   .time = t,
                   .expected = at.along,
                   .allowed = off,
                   .source = "r cos a + sqrt(l^2 - r^2 sin^2 a); the slop of three joints"});
    all.push_back({.body = "piston",
                   .quantity = Quantity::vx,
                   .time = t,
                   .expected = at.speed,
                   .allowed = speed,
                   .source = "its derivative; a step's change of velocity"});
    all.push_back({.body = "rod",
                   .quantity = Quantity::angle,
                   .time = t,
                   .expected = at.tilt,
                   .allowed = [=](const Stepping& s) { return 2 * off(s) / rod; },
                   .source = "sin = r sin a/l; the slop at both ends"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "slider-crank",
     .question = "Does a crank at constant speed move its piston as the geometry says?",
     .parameters = {{.name = "turn", .value = 3, .min = 0.5, .max = 10, .unit = "rad/s", .about = "of the crank"}},
     .variants = {{"3rad/s", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::slider_crank

namespace plumb::scenarios::turning_rail {
namespace {

constexpr double duration = 1;  // s
constexpr double from = 0.5;    // m, of the bead from the axis

Scene scene(const Parameters& p) {
  const double turn = p.at("turn");
  Scene scene{.name = "turning-rail",
              .about = "A bead slides outwards on a rail that turns regardless.",
              .gravity = {0, 0},
              .duration = duration};
  Body rail = box("rail", {0, 0}, {0.4, 0.1}, {});
  rail.type = BodyType::kinematic;
  rail.angular_velocity = turn;
  rail.layers = 0;
  Body bead = box("bead", {from, 0}, {0.4, 0.2}, {});
  bead.layers = 0;
  bead.velocity = {0, turn * from};
  bead.angular_velocity = turn;
  scene.bodies = {rail, bead};
  scene.joints.push_back(Prismatic{.a = 0, .b = 1, .anchor = {from, 0}});
  return scene;
}

// Along the rail r'' = W^2 r: r = r0 cosh(W t) (Landau & Lifshitz, Mechanics, 39). With k = W h:
//   first order   the bead moves along its tangent and the rail takes what is across: both r and its rate are off by
//                 k/2 of themselves per W t, twice: for the step's length and for the direction; and the drift;
//   second order  k^2/3 per W t;
//   slop          of the joint, which grows like r itself.
std::vector<Expectation> expectations(const Parameters& p) {
  const double turn = p.at("turn");
  const double swept = turn * duration;
  const double r = from * std::cosh(swept);
  const auto off = [=](const Stepping& s) {
    const double k = turn * s.h;
    const double share = first_order(s) ? k + std::abs(s.drift) * k / swept : k * k / 3;
    return from * std::exp(swept) * share * swept +
           std::cosh(swept) * (s.joint_slop + round_off(s, duration, 1 + r * (1 + turn)));
  };
  return {{.body = "bead",
           .quantity = Quantity::x,
           .expected = r * std::cos(swept),
           .allowed = off,
           .source = "r0 cosh(W t) along the rail; the method's order, slop"},
          {.body = "bead",
           .quantity = Quantity::y,
           .expected = r * std::sin(swept),
           .allowed = off,
           .source = "r0 cosh(W t) along the rail; the method's order, slop"},
          {.body = "bead",
           .quantity = Quantity::speed,
           .expected = turn * from * std::sqrt(std::cosh(2 * swept)),
           .allowed = [=](const Stepping& s) { return turn * off(s) + (first_order(s) ? turn * turn * s.h * r : 0); },
           .source = "r0 W sqrt(sinh^2 + cosh^2); the method's order, slop"},
          {.body = "bead",
           .quantity = Quantity::angle,
           .expected = swept,
           .allowed = [=](const Stepping& s) { return 2 * s.joint_slop / 0.4 + round_off(s, duration, 1 + swept); },
           .source = "turns with the rail; slop at both ends of the bead"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "turning-rail",
     .question = "Does a bead on a turning rail fly outwards with r0 cosh(W t)?",
     .parameters = {{.name = "turn", .value = 2, .min = 0.5, .max = 4, .unit = "rad/s", .about = "of the rail"}},
     .variants = {{"2rad/s", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::turning_rail
