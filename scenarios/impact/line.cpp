#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::head_on {
namespace {

constexpr double duration = 2;  // s
constexpr double radius = 0.5;  // m
constexpr double apart = 2.03;  // m between the rims, chosen so that no impact coincides with a step

Scene scene(const Parameters& p) {
  const double e = p.at("restitution");
  Scene scene{.name = "head-on", .about = "Two discs collide head-on.", .gravity = {0, 0}, .duration = duration};
  scene.bodies.push_back(disc("left", {-radius - apart / 2, 0}, radius, surface(0, e)));
  scene.bodies.push_back(disc("right", {radius + apart / 2, 0}, radius, surface(0, e, p.at("ratio"))));
  scene.bodies[0].velocity = {p.at("left"), 0};
  scene.bodies[1].velocity = {-p.at("right"), 0};
  return scene;
}

// The velocities do not depend on when the impact is found. The positions are off by the velocity jump times the time
// by which it is found late or early. Moving the discs apart only undoes some of being late; at rest on each other, e =
// 0, they may be apart by the gap.
std::vector<Expectation> expectations(const Parameters& p) {
  const double approach = p.at("left") + p.at("right");
  const double e = p.at("restitution");
  const double ratio = p.at("ratio");
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, apart + 2 * approach * duration); };
  std::vector<Expectation> all;
  for (const char* body : {"left", "right"}) {
    const double share = (body == std::string("left") ? ratio : 1) / (1 + ratio);  // of the change of velocity
    const auto place = [=](const Stepping& s) {
      const double rests = e == 0 || approach < s.restitution_threshold ? s.contact_gap() : 0;
      return share * ((1 + e) * approach * found_off(s, approach) + rests) + exact(s);
    };
    all.push_back(
        {.body = body, .quantity = Quantity::vx, .allowed = exact, .source = "((m1 - e m2) v1 + (1+e) m2 v2)/(m1+m2)"});
    all.push_back(
        {.body = body, .quantity = Quantity::x, .allowed = place, .source = "the velocity jump times the lag"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "head-on",
     .question = "Do two colliding discs share momentum according to their masses and restitution?",
     .parameters = {{.name = "ratio",
                     .value = 3,
                     .min = 0.001,
                     .max = 1000,
                     .about = "mass of the right disc divided by that of the left"},
                    {.name = "left",
                     .value = 3,
                     .min = 1,
                     .max = 50,
                     .unit = "m/s",
                     .about = "speed of the left disc, to the right"},
                    {.name = "right",
                     .value = 1,
                     .min = 0,
                     .max = 50,
                     .unit = "m/s",
                     .about = "speed of the right disc, to the left"},
                    {.name = "restitution", .value = 0.5, .min = 0, .max = 1, .about = "of both discs"}},
     .variants = {{"e=0.5", {}}, {"e=1", {{"restitution", 1}}}, {"e=0", {{"restitution", 0}}}},
     .closed_form = "line",
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::head_on

namespace plumb::scenarios::cradle {
namespace {

constexpr double duration = 2;   // s
constexpr double radius = 0.5;   // m
constexpr double run_up = 0.53;  // m, distance to the first impact

std::string ball(int i) { return "ball " + std::to_string(i); }

Scene scene(const Parameters& p) {
  Scene scene{.name = "cradle", .about = "One disc hits a row of equal ones.", .gravity = {0, 0}, .duration = duration};
  const int balls = static_cast<int>(p.at("balls"));
  for (int i = 1; i <= balls; ++i) {
    const double x = (i - 1) * (2 * radius + p.at("gap")) - (i == 1 ? run_up : 0);
    scene.bodies.push_back(disc(ball(i), {x, 0}, radius, surface(0, 1)));
  }
  scene.bodies.front().velocity = {p.at("speed"), 0};
  return scene;
}

// Equal masses with e = 1 swap velocities, one pair after the other, however late each impact is found, and only the
// last ball leaves. Each other ball moves until it is found to touch the next, and stays where it is then: off by v
// times that lag alone. The last one is late by all the impacts before. Moving two balls apart only undoes some of
// being late.
std::vector<Expectation> expectations(const Parameters& p) {
  const int balls = static_cast<int>(p.at("balls"));
  const double v = p.at("speed");
  std::vector<Expectation> all;
  for (int i = 1; i <= balls; ++i) {
    const auto exact = [=](const Stepping& s) { return round_off(s, duration, 2 * balls * radius + v * duration); };
    const double late = i == balls ? balls - 1 : 1;  // impacts
    const auto place = [=](const Stepping& s) { return late * v * found_off(s, v) + exact(s); };
    all.push_back(
        {.body = ball(i), .quantity = Quantity::vx, .allowed = exact, .source = "equal balls swap velocities"});
    all.push_back({.body = ball(i),
                   .quantity = Quantity::x,
                   .allowed = place,
                   .source = "equal balls swap velocities; a lag late each time"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "cradle",
     .question = "Does a row of balls pass on the velocity so that only the last one leaves?",
     .parameters = {{.name = "balls",
                     .value = 5,
                     .min = 2,
                     .max = 20,
                     .about = "in the row, including the moving one",
                     .whole = true},
                    {.name = "gap",
                     .value = 0.05,
                     .min = 1e-3,
                     .max = 1,
                     .unit = "m",
                     .about = "between neighbours, so that only two collide at a time"},
                    {.name = "speed", .value = 2, .min = 1.5, .max = 20, .unit = "m/s", .about = "of the first ball"}},
     .variants = {{"five", {}}},
     .closed_form = "line",
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::cradle

namespace plumb::scenarios::pi_billiard {
namespace {

constexpr double duration = 6;  // s
constexpr double speed = 2;     // m/s, of the heavy block towards the light one

Scene scene(const Parameters& p) {
  const Surface elastic = surface(0, 1);
  Scene scene{.name = "pi-billiard",
              .about = "A heavy block drives a light one against a wall, without friction or energy loss.",
              .gravity = {0, 0},
              .duration = duration};
  const Body wall = half_space("wall", {.normal = {1, 0}}, elastic);
  Body light = box("light", {2.5, 0}, {1, 1}, elastic);
  Body heavy = box("heavy", {6.03, 0}, {1, 1}, surface(0, 1, std::pow(100, p.at("digits"))));
  heavy.velocity = {-speed, 0};
  scene.bodies = {wall, light, heavy};
  return scene;
}

// The blocks' impacts, one after the other, until the end.
struct Blocks {
  double heavy = -speed, light = 0;  // m/s
  double shortest = duration;        // s, between two impacts
  int impacts = 0;
};

Blocks after_all_impacts(double ratio) {
  Blocks now;
  double between = 2.53;  // m, from block to block
  double to_wall = 2;     // m
  double left = duration;
  while (true) {
    const double closes = now.light - now.heavy;
    const double meet = closes > 0 ? between / closes : duration;
    const double wall = now.light < 0 ? to_wall / -now.light : duration;
    const double next = std::min(meet, wall);
    if (next >= left) return now;
    if (now.impacts > 0) now.shortest = std::min(now.shortest, next);
    left -= next;
    between -= closes * next;
    to_wall += now.light * next;
    ++now.impacts;
    if (wall < meet) {
      now.light = -now.light;
    } else {
      const double mean = (ratio * now.heavy + now.light) / (ratio + 1);
      now.heavy = 2 * mean - now.heavy;
      now.light = 2 * mean - now.light;
    }
  }
}

// In the plane of sqrt(M) V and sqrt(m) v, constant energy is a circle, and each pair of impacts turns the state by a
// fixed angle 2 q, tan q = sqrt(m/M) = 10^-digits: hence floor(pi 10^digits) impacts (Galperin). Each number of impacts
// leads to velocities of its own, so that both velocities at the end count them; when each was found does not matter,
// as long as they come one by one. Where two may fall into one lag, a method may miss the count, but a state in which
// nothing approaches any more has 0 <= v <= V, where V lies between V0 cos q and V0.
// Every impact conserves energy whenever it happens; each iteration over it rounds the velocities.
std::vector<Expectation> expectations(const Parameters& p) {
  const double ratio = std::pow(100, p.at("digits"));
  const double q = std::atan(1 / std::sqrt(ratio));
  const Blocks end = after_all_impacts(ratio);
  const double energy = mass_of(scene(p).bodies[2]).mass * speed * speed / 2;
  const auto exact = [=](const Stepping& s) {
    return round_off(s, duration, 10) + 4 * s.epsilon * (1 + end.impacts) * (1 + s.iterations) * speed;
  };
  const auto one_by_one = [=](const Stepping& s) { return end.shortest > 2 * (lag(s) + s.skin / speed); };
  return {{.body = "heavy",
           .quantity = Quantity::vx,
           .expected = end.heavy,
           .allowed =
               [=](const Stepping& s) {
                 return (one_by_one(s) ? 0 : std::max(speed - end.heavy, end.heavy - speed * std::cos(q))) + exact(s);
               },
           .source = "after floor(pi 10^digits) impacts; V0 cos q <= V <= V0 if two fall into one lag"},
          {.body = "light",
           .quantity = Quantity::vx,
           .expected = end.light,
           .allowed =
               [=](const Stepping& s) {
                 return (one_by_one(s) ? 0 : std::max(speed - end.light, end.light)) + std::sqrt(ratio) * exact(s);
               },
           .source = "after floor(pi 10^digits) impacts; 0 <= v <= V if two fall into one lag"},
          {.quantity = Quantity::energy,
           .allowed = [=](const Stepping& s) { return 2 * energy / speed * exact(s); },
           .source = "constant, as e = 1"}};
}

const Catalog<Scenario>::Entry entry{{.name = "pi-billiard",
                                      .question = "Do two blocks and a wall collide as often as the digits of pi say?",
                                      .parameters = {{.name = "digits",
                                                      .value = 1,
                                                      .min = 0,
                                                      .max = 3,
                                                      .about = "digits of pi: mass ratio 100^digits",
                                                      .whole = true}},
                                      .variants = {{"3", {{"digits", 0}}}, {"31", {}}, {"314", {{"digits", 2}}}},
                                      .closed_form = "line",
                                      .scene = scene,
                                      .expectations = expectations,
                                      .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::pi_billiard

namespace plumb::scenarios::thin_wall {
namespace {

constexpr double duration = 0.5;    // s
constexpr double radius = 0.1;      // m
constexpr double thickness = 0.02;  // m
constexpr double distance = 3.03;   // m to the wall

Scene scene(const Parameters& p) {
  Scene scene{
      .name = "thin-wall", .about = "A fast disc flies at a thin wall.", .gravity = {0, 0}, .duration = duration};
  Body bullet = disc("bullet", {-distance - radius, 0}, radius, surface(0, 0));
  bullet.bullet = true;
  bullet.velocity = {p.at("speed"), 0};
  Body wall = box("wall", {thickness / 2, 0}, {thickness, 4}, surface(0, 0));
  wall.type = BodyType::fixed;
  scene.bodies = {bullet, wall};
  return scene;
}

// e = 0: the bullet stops at the wall, within the gap. An impact that is found late leaves it that deep in, but never
// with its centre beyond the middle of the wall: from there no engine can know which way is out.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const auto place = [=](const Stepping& s) {
    const double late = std::max(v * lag(s), s.contact_gap());
    return std::min(late, radius + thickness / 2) + round_off(s, duration, distance + v * duration);
  };
  const auto speed = [=](const Stepping& s) { return round_off(s, duration, v); };
  return {{.body = "bullet", .quantity = Quantity::x, .allowed = place, .source = "stops at the wall, never behind it"},
          {.body = "bullet", .quantity = Quantity::vx, .allowed = speed, .source = "stops, as e = 0"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "thin-wall",
     .question = "Does a fast body stop at a wall that is thinner than its motion per step?",
     .parameters = {{.name = "speed", .value = 100, .min = 10, .max = 1000, .unit = "m/s", .about = "of the bullet"}},
     .variants = {{"slow", {{"speed", 10}}}, {"fast", {}}},
     .closed_form = "line",
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::thin_wall
