#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

// Bodies that have been at rest for so long that an engine may have put them to sleep, and then something happens.
// Without friction what happens has a closed form.
namespace plumb::scenarios::disturbed {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double rest = 2;      // s, until the blow

// A disc that flies on a straight line and hits whatever is at `target`, m, at the end of the rest. Its restitution is
// 1, and that of all else 0: the larger counts.
Body striker(double target, double height, double mass, double speed) {
  constexpr double radius = 0.5;
  const double area = std::numbers::pi * radius * radius;
  Body made = disc("striker", {target - radius - speed * rest, height}, radius, surface(0, 1, mass / area));
  made.velocity = {speed, 0};
  made.gravity_scale = 0;
  return made;
}

}  // namespace
}  // namespace plumb::scenarios::disturbed

namespace plumb::scenarios::late_blow {
namespace {

constexpr double duration = 3;  // s
const Vec size{1, 1};           // m

Scene scene(const Parameters& p) {
  Scene scene{.name = "late-blow",
              .about = "A box that has rested for two seconds is struck.",
              .gravity = {0, -disturbed::gravity},
              .duration = duration};
  scene.bodies.push_back(level_ground(surface(0, 0)));
  scene.bodies.push_back(box("box", {0, size.y / 2}, size, surface(0, 0)));
  scene.bodies.push_back(disturbed::striker(-size.x / 2, size.y / 2, size.x * size.y, p.at("speed")));
  return scene;
}

// Equal masses swap velocities, as e = 1 and the push goes through both centres. Off as in a head-on impact, and in
// height by the gap.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double reach = v * duration + disturbed::gravity * duration;
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, reach); };
  const auto place = [=](const Stepping& s) { return 3 * v * lag(s) + s.contact_gap() + exact(s) * duration; };
  return {
      {.body = "box",
       .quantity = Quantity::x,
       .time = disturbed::rest / 2,
       .expected = 0,
       .allowed = exact,
       .source = "rests until it is struck"},
      {.body = "box",
       .quantity = Quantity::vx,
       .expected = v,
       .allowed = exact,
       .source = "equal masses swap velocities"},
      {.body = "striker",
       .quantity = Quantity::vx,
       .expected = 0,
       .allowed = exact,
       .source = "equal masses swap velocities"},
      {.body = "box",
       .quantity = Quantity::x,
       .expected = v * (duration - disturbed::rest),
       .allowed = place,
       .source = "moves from the moment of the blow; the velocity jump times the lag, and the penetration"},
      {.body = "box",
       .quantity = Quantity::y,
       .expected = size.y / 2,
       .allowed =
           [=](const Stepping& s) { return s.contact_gap() + disturbed::gravity * lag(s) * (lag(s) + s.h) + exact(s); },
       .source = "stays on the ground"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "late-blow",
     .question = "Does a body that has long been at rest take up a blow at once?",
     .parameters = {{.name = "speed", .value = 4, .min = 1.5, .max = 20, .unit = "m/s", .about = "of the striker"}},
     .variants = {{"box", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::late_blow

namespace plumb::scenarios::lost_support {
namespace {

constexpr double duration = 3;  // s: it falls for so long that what may be late is little
constexpr double radius = 0.3;  // m
constexpr double place = 1.07;  // m, of the disc: its support ends between two steps
constexpr double speed = 12;    // m/s: speed^2 > g radius, so that the plank's edge leaves the disc behind
constexpr Vec plank{4, 3};      // m

constexpr double moment =
    disturbed::rest + (place + plank.x / 2) / speed;  // s, at which the edge passes the disc's centre

Scene scene(const Parameters&) {
  Scene scene{.name = "lost-support",
              .about = "The plank on which a disc has rested for two seconds is knocked away.",
              .gravity = {0, -disturbed::gravity},
              .duration = duration};
  scene.bodies.push_back(level_ground(surface(0, 0)));
  scene.bodies.push_back(box("plank", {0, plank.y / 2}, plank, surface(0, 0)));
  scene.bodies.push_back(disc("disc", {place, plank.y + radius}, radius, surface(0, 0)));
  scene.bodies.push_back(disturbed::striker(-plank.x / 2, plank.y / 2, plank.x * plank.y, speed));
  return scene;
}

// The plank leaves with the striker's velocity, and the disc falls freely from the moment at which it has no support.
// It is supported for longer by the lag of the blow, by the time in which the plank moves by the gap, and by a step, as
// contacts are found once in each; and it may fall by the gap less or more. In that time t it pushes the plank's edge
// with its weight, at an angle of up to V t/r.
std::vector<Expectation> expectations(const Parameters&) {
  const double fallen = duration - moment;
  const double reach = disturbed::gravity * duration * duration;
  const auto late = [=](const Stepping& s) { return lag(s) + 2 * s.contact_gap() / speed + (s.h > 0 ? s.dt : 0); };
  const auto velocity = [=](const Stepping& s) { return disturbed::gravity * late(s) + round_off(s, duration, reach); };
  const auto height = [=](const Stepping& s) {
    return disturbed::gravity * (fallen + late(s)) * late(s) + drifted(s, disturbed::gravity, fallen) +
           2 * s.contact_gap() + round_off(s, duration, reach);
  };
  const double share = std::numbers::pi * radius * radius / (plank.x * plank.y);
  const auto pushed = [=](const Stepping& s) {
    return share * disturbed::gravity * late(s) * std::min(1.0, speed * late(s) / radius) +
           round_off(s, duration, reach);
  };
  const double top = plank.y + radius;
  return {{.body = "disc",
           .quantity = Quantity::y,
           .time = disturbed::rest,
           .expected = top,
           .allowed = [=](const Stepping& s) { return 2 * s.contact_gap() + round_off(s, duration, reach); },
           .source = "rests on the plank"},
          {.body = "disc",
           .quantity = Quantity::vy,
           .expected = -disturbed::gravity * fallen,
           .allowed = velocity,
           .source = "falls freely once the edge has passed its centre; a lag, the gap and a step later"},
          {.body = "disc",
           .quantity = Quantity::y,
           .expected = top - disturbed::gravity * fallen * fallen / 2,
           .allowed = height,
           .source = "falls freely once the edge has passed its centre; a lag, the gap and a step later"},
          {.body = "plank",
           .quantity = Quantity::vx,
           .expected = speed,
           .allowed = pushed,
           .source = "equal masses swap velocities; the push of the disc on its edge"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "lost-support",
     .question = "Does a body that has long been at rest fall when its support is knocked away?",
     .variants = {{"disc", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::lost_support
