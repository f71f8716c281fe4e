#include <cmath>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::touching_cradle {
namespace {

constexpr double duration = 1;   // s
constexpr double radius = 0.5;   // m
constexpr double run_up = 0.53;  // m, distance to the impact

std::string ball(int i) { return "ball " + std::to_string(i); }

Scene scene(const Parameters& p) {
  Scene scene{.name = "touching-cradle",
              .about = "One disc hits a row of equal ones that touch.",
              .gravity = {0, 0},
              .duration = duration};
  for (int i = 1; i <= static_cast<int>(p.at("balls")); ++i) {
    scene.bodies.push_back(disc(ball(i), {(i - 1) * 2 * radius - (i == 1 ? run_up : 0), 0}, radius, surface(0, 1)));
  }
  scene.bodies.front().velocity = {p.at("speed"), 0};
  return scene;
}

// Rigid bodies that touch leave the outcome open (Herrmann, Schmaelzle, Am. J. Phys. 49, 1981): momentum and energy
// hold, and no ball is pulled or passes the next, v1 <= v2 <= ... <= vn. Of all such outcomes,
//   the last ball is at most as fast as the first was, and at least 2/n of it: no ball is faster than the last, and
//   with n - 1 of them equally fast and one slower the sums of v and v^2 leave just that; the first ball is at rest or
//   rebounds, by at most (n - 2)/n, for the same reason with all others equally fast.
// At one end are impacts one after the other, as waves in real balls make them, about; at the other all at once, each
// with its own restitution (Newton's law at every contact). The readings show which was taken. Each iteration over the
// impacts rounds; those that are too few leave a share of the row's relative velocities unsolved, which is missing from
// the energy and the bounds, and never from the momentum.
std::vector<Expectation> expectations(const Parameters& p) {
  const int balls = static_cast<int>(p.at("balls"));
  const double v = p.at("speed");
  const double mass = mass_of(scene(p).bodies[0]).mass;
  const auto exact = [=](const Stepping& s) {
    return round_off(s, duration, 2 * balls * radius + v * duration) + 4 * s.epsilon * s.iterations * v;
  };
  const auto bound = [=](const Stepping& s) { return exact(s) + 2 * v * unsolved(s, balls); };
  const double n = balls;
  const std::string first = ball(1);
  const std::string last = ball(balls);
  std::vector<Expectation> all;
  const auto add = [&](const std::string& body, Relation relation, double share, const char* source) {
    all.push_back({.body = body,
                   .quantity = Quantity::vx,
                   .relation = relation,
                   .expected = share * v,
                   .allowed = bound,
                   .source = source});
  };
  add(last, Relation::at_most, 1, "impacts one after the other: the last ball leaves with all of the speed");
  add(last, Relation::at_least, 2 / n, "all at once: n - 1 balls leave with 2/n of the speed");
  add(first, Relation::at_most, 0, "impacts one after the other: the first ball stops");
  add(first, Relation::at_least, -(n - 2) / n, "all at once: the first ball rebounds with (n - 2)/n of the speed");
  all.push_back({.quantity = Quantity::momentum_x,
                 .expected = mass * v,
                 .allowed = [=](const Stepping& s) { return mass * n * exact(s); },
                 .source = "every impact keeps it"});
  all.push_back({.quantity = Quantity::energy,
                 .expected = mass * v * v / 2,
                 .allowed = [=](const Stepping& s) { return 2 * mass * v * bound(s); },
                 .source = "every impact keeps it, as e = 1"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "touching-cradle",
     .question = "Does a row of balls that touch keep momentum and energy without pulling, whichever end it takes?",
     .parameters =
         {{.name = "balls", .value = 5, .min = 3, .max = 10, .about = "in the row, including the first", .whole = true},
          {.name = "speed", .value = 2, .min = 1.5, .max = 20, .unit = "m/s", .about = "of the first ball"}},
     .variants = {{"three", {{"balls", 3}}}, {"five", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::touching_cradle
