#include <algorithm>
#include <cmath>
#include <string>

#include "scenarios/allowance.h"
#include "scenarios/contact/rolls_off.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::table_edge {
namespace {

constexpr double gravity = 10;   // m/s^2
constexpr double radius = 0.5;   // m, of the disc
constexpr double run_up = 0.31;  // m, from where it rolls to the edge
constexpr double flies = 0.8;    // s, for which it is watched once it has left
constexpr Vec table{4, 1};       // m

RollsOff edge_of(const Parameters& p) {
  return {.gravity = gravity, .around = radius, .radius = radius, .friction = p.at("friction")};
}

double at_edge(const Parameters& p) { return run_up / p.at("speed"); }  // s

// Over the edge it goes on as it rolled; where v^2 > g r it flies on at once.
RollsOff::Left leaves(const Parameters& p) {
  const double turns = p.at("speed") / radius;
  const RollsOff::State start{0, turns, turns};
  const RollsOff edge = edge_of(p);
  return edge.load(start) <= 0 ? RollsOff::Left{0, start} : edge.from(start, 100);
}

double duration(const Parameters& p) { return whole_steps(at_edge(p) + leaves(p).time + flies); }

Scene scene(const Parameters& p) {
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "table-edge",
              .about = "A disc rolls over the edge of a table.",
              .gravity = {0, -gravity},
              .duration = duration(p)};
  Body disc = plumb::disc("disc", {-run_up, radius}, radius, rough);
  disc.velocity = {p.at("speed"), 0};
  disc.angular_velocity = -p.at("speed") / radius;
  scene.bodies = {fixed(box("table", {-table.x / 2, -table.y / 2}, table, rough)), disc};
  return scene;
}

// On the table it rolls steadily; found to touch it a lag late it has fallen, and slides for that long. The load of the
// table is g, that of the edge g - v^2/r. A method that notices the edge up to a step late, as contacts are found once
// in each, lets the centre go straight on:
//   flies     off at once: g dt of its fall is missing, and the tilted edge, by a = v dt/r, gives at most g dt sin a to
//             the side, a rolling disc's friction no more;
//   rolls on  it has left the edge with v a, a = v dt/r, is back after t = 2 v a/(g - v^2/r), and was not held back by
//             g sin a/3 until then.
// About the edge it is off as RollsOff says; errors grow as cosh(w t) and are as much, times w, in the rate. In flight
// what was wrong in velocity moves it on, and the method drifts.
std::vector<Expectation> expectations(const Parameters& p) {
  const RollsOff edge = edge_of(p);
  const RollsOff::Left end = leaves(p);
  const bool rolls = end.time > 0;
  const double w = edge.growth();
  const double v = p.at("speed");
  const double fastest = end.state[1];
  const double total = duration(p);
  const double flight = total - at_edge(p) - end.time;
  const double speed = radius * fastest;
  const Vec velocity{speed * std::cos(end.state[0]), -speed * std::sin(end.state[0])};
  const Vec from{radius * std::sin(end.state[0]), radius * std::cos(end.state[0])};
  const double reach = run_up + radius + speed * total;
  const auto late = [](const Stepping& s) { return s.h > 0 ? s.dt : 0; };  // s
  const auto hopped = [=](const Stepping& s) {                             // m/s
    const double away = v * v * late(s) / radius;
    const double back = 2 * away / (gravity - v * v / radius);
    return gravity * v * (late(s) + back) / radius / 3 * back;
  };
  const auto turn = [=](const Stepping& s) {
    const double grown = std::cosh(w * end.time);
    const double before = slid_late(s, gravity) / radius + hopped(s) / radius / w;
    return edge.off(s, end.time, end.state[0], fastest) + before * grown + round_off(s, total, reach) * grown;
  };
  const auto moves = [=](const Stepping& s) {
    return (rolls ? radius * w * turn(s) : gravity * late(s) * std::sin(std::min(v * late(s) / radius, 1.0))) +
           round_off(s, total, reach);
  };
  const auto falls = [=](const Stepping& s) { return rolls ? moves(s) : gravity * late(s) + moves(s); };
  const auto lands = [=](const auto& wrong) {
    return [=](const Stepping& s) {
      const double left = rolls ? radius * turn(s) : slid_late(s, gravity) + round_off(s, total, reach);
      return left + s.contact_gap() + wrong(s) * flight + drifted(s, gravity, flight);
    };
  };
  const std::string law = rolls ? "rolls about the edge, slips and leaves where the load is 0: about cos a = 4/7 + 3 "
                                  "v^2/(7 g r)"
                                : "leaves at once, as v^2 > g r";
  std::vector<Expectation> all;
  const auto add = [&](Quantity quantity, double expected, const auto& allowed) {
    all.push_back({.body = "disc", .quantity = quantity, .expected = expected, .allowed = allowed, .source = law});
  };
  add(Quantity::x, from.x + velocity.x * flight, lands(moves));
  add(Quantity::y, from.y + velocity.y * flight - gravity * flight * flight / 2, lands(falls));
  add(Quantity::vx, velocity.x, moves);
  add(Quantity::angular_velocity, -end.state[2],
      [=](const Stepping& s) { return 2 / radius * moves(s) + speed / radius * s.contact_gap() / radius; });
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "table-edge",
     .question = "Does a disc roll over the edge of a table, and leave it about where cos a = 4/7 + 3 v^2/(7 g r)?",
     .parameters = {{.name = "speed", .value = 1, .min = 0.5, .max = 4, .unit = "m/s", .about = "of the disc"},
                    {.name = "friction", .value = 5, .min = 1, .max = 20, .about = "of disc and table"}},
     .variants = {{"rolls", {}}, {"flies", {{"speed", 3}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::table_edge
