#include <cmath>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

// Discs that kinematic walls throw back. The walls are much thicker than any body moves in a step.
namespace plumb::scenarios::paddle {
namespace {

constexpr double duration = 1;    // s
constexpr double moment = 0.493;  // s, of the impact: between two steps
constexpr double radius = 0.25;   // m
constexpr Vec size{1, 4};         // m, of the paddle

// The paddle's right side is at the origin at the impact.
Scene scene(const Parameters& p) {
  const Surface of = surface(0, p.at("restitution"));
  Scene scene{.name = "paddle",
              .about = "A paddle that moves on regardless throws back a ball.",
              .gravity = {0, 0},
              .duration = duration};
  Body moved = box("paddle", {-size.x / 2 - p.at("paddle") * moment, 0}, size, of);
  moved.type = BodyType::kinematic;
  moved.velocity = {p.at("paddle"), 0};
  Body ball = disc("ball", {radius + p.at("ball") * moment, 0}, radius, of);
  ball.velocity = {-p.at("ball"), 0};
  scene.bodies = {moved, ball};
  return scene;
}

// Seen from the paddle the ball comes with v + V and leaves with e times that, whenever the impact is found. Its
// position is off by the jump times the time by which it is found late or early; at rest on the paddle, e = 0, by the
// gap.
std::vector<Expectation> expectations(const Parameters& p) {
  const double paddle = p.at("paddle");
  const double ball = p.at("ball");
  const double e = p.at("restitution");
  const double approach = paddle + ball;
  const double leaves = paddle + e * approach;
  const double reach = 2 * (1 + std::abs(paddle) + ball) * (1 + duration);
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, reach); };
  const auto slow = [=](const Stepping& s) { return approach < s.restitution_threshold ? e * approach : 0; };
  const auto place = [=](const Stepping& s) {
    const double rests = e == 0 || slow(s) > 0 ? s.contact_gap() : 0;
    return (1 + e) * approach * found_off(s, approach) + rests + slow(s) * (duration - moment) + exact(s);
  };
  return {{.body = "ball",
           .quantity = Quantity::vx,
           .expected = leaves,
           .allowed = [=](const Stepping& s) { return slow(s) + exact(s); },
           .source = "V + e (v + V), whenever the impact is found"},
          {.body = "ball",
           .quantity = Quantity::x,
           .expected = radius + leaves * (duration - moment),
           .allowed = place,
           .source = "the velocity jump times the lag"},
          {.body = "paddle",
           .quantity = Quantity::x,
           .expected = -size.x / 2 + paddle * (duration - moment),
           .allowed = exact,
           .source = "a kinematic body is moved by nothing"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "paddle",
     .question = "Does a moving paddle throw a ball back with V + e (v + V)?",
     .parameters =
         {{.name = "paddle", .value = 2, .min = -1, .max = 10, .unit = "m/s", .about = "speed towards the ball"},
          {.name = "ball", .value = 3, .min = 2, .max = 20, .unit = "m/s", .about = "speed towards the paddle"},
          {.name = "restitution", .value = 0.8, .min = 0, .max = 1, .about = "of paddle and ball"}},
     .variants = {{"hits", {}}, {"recedes", {{"paddle", -1}, {"restitution", 1}}}, {"catches", {{"restitution", 0}}}},
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::paddle

namespace plumb::scenarios::closing_walls {
namespace {

constexpr double radius = 0.25;    // m
constexpr double half = 2;         // m, from the middle to either wall's inner side at the start
constexpr double from = -0.3;      // m, of the ball's centre
constexpr Vec size{1, 4};          // m, of either wall
constexpr double duration = 1.05;  // s, well between two impacts

Scene scene(const Parameters& p) {
  const Surface elastic = surface(0, 1);
  Scene scene{.name = "closing-walls",
              .about = "A ball flies back and forth between two walls that close in.",
              .gravity = {0, 0},
              .duration = duration};
  Body ball = disc("ball", {from, 0}, radius, elastic);
  ball.velocity = {p.at("ball"), 0};
  scene.bodies.push_back(ball);
  for (const double side : {-1.0, 1.0}) {
    Body wall = box(side < 0 ? "left" : "right", {side * (half + size.x / 2), 0}, size, elastic);
    wall.type = BodyType::kinematic;
    wall.velocity = {-side * p.at("walls"), 0};
    scene.bodies.push_back(wall);
  }
  return scene;
}

// Where the ball is after t seconds, and how fast and after how many impacts.
struct Flight {
  double place, velocity;
  int impacts;
};

// Every impact adds 2 V to the speed (Fermi 1949). Between two, the ball at half - r - V t from the middle crosses to
// the other wall, which comes to meet it.
Flight flight(double ball, double walls, double t) {
  double now = 0;
  Flight at{from, ball, 0};
  while (true) {
    const double way = at.velocity > 0 ? 1 : -1;
    const double speed = std::abs(at.velocity);
    const double next = (half - radius - walls * now - way * at.place) / (speed + walls);
    if (now + next > t) return {at.place + at.velocity * (t - now), at.velocity, at.impacts};
    now += next;
    at = {at.place + at.velocity * next, -way * (speed + 2 * walls), at.impacts + 1};
  }
}

// Speeds do not depend on when impacts are found. Each that is found late or early moves the ball by twice the closing
// speed, times that time.
std::vector<Expectation> expectations(const Parameters& p) {
  const double walls = p.at("walls");
  const Flight end = flight(p.at("ball"), walls, duration);
  const double fastest = std::abs(end.velocity) + walls;
  const double reach = 2 * (half + fastest * duration);
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, reach) * (1 + end.impacts); };
  const auto place = [=](const Stepping& s) {
    return end.impacts * 2 * fastest * found_off(s, p.at("ball") + walls) + exact(s);
  };
  return {{.body = "ball",
           .quantity = Quantity::vx,
           .expected = end.velocity,
           .allowed = exact,
           .source = "v + 2 n V after n impacts, whenever they are found"},
          {.body = "ball",
           .quantity = Quantity::x,
           .expected = end.place,
           .allowed = place,
           .source = "between two impacts; each that is found late moves it by its jump times the lag"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "closing-walls",
     .question = "Does a ball between two walls that close in gain twice their speed at each impact?",
     .parameters =
         {{.name = "ball", .value = 6, .min = 2, .max = 12, .unit = "m/s", .about = "speed at the start"},
          {.name = "walls", .value = 0.7, .min = 0, .max = 1, .unit = "m/s", .about = "speed of either wall"}},
     .variants = {{"V=0.7", {}}},
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::closing_walls
