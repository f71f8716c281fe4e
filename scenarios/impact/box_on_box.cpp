#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::box_on_box {
namespace {

constexpr double side = 1;        // m, of either box
constexpr double moment = 0.493;  // s, of the impact: between two steps
constexpr double duration = 0.6;  // s, before the turning boxes can meet again

Scene scene(const Parameters& p) {
  const double e = p.at("restitution");
  Scene scene{.name = "box-on-box",
              .about = "A box flies flat against another one, both free.",
              .gravity = {0, 0},
              .duration = duration};
  Body flies = box("flies", {-side - p.at("speed") * moment, 0}, {side, side}, surface(0, e));
  flies.velocity = {p.at("speed"), 0};
  scene.bodies = {flies, box("struck", {0, p.at("offset")}, {side, side}, surface(0, e, p.at("ratio")))};
  return scene;
}

// Smooth faces that meet flat touch at both ends of their overlap, and both ends obey Newton's law only if the boxes
// turn alike afterwards: a/I1 = b/I2 of the levers a + b = d (Moreau 1988: two unilateral constraints, both active).
// The blow then goes through one point, J = (1 + e) v/(1/m1 + 1/m2 + a^2/I1 + b^2/I2), which is within the overlap for
// any offset up to half a side. Velocities do not depend on when the impact is found, nor do places beyond their jump
// times the time by which it is found late or early. Iterations over both ends leave a share of the blow.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene built = scene(p);
  const Mass first = mass_of(built.bodies[0]);
  const Mass second = mass_of(built.bodies[1]);
  const double v = p.at("speed");
  const double a = p.at("offset") * first.inertia / (first.inertia + second.inertia);
  const double b = p.at("offset") - a;
  const double yields = 1 / first.mass + 1 / second.mass + a * a / first.inertia + b * b / second.inertia;
  const double blow = (1 + p.at("restitution")) * v / yields;
  const double spin = a * blow / first.inertia;
  const double left = duration - moment;
  // How a blow at one point, m above the resultant of both, is felt at another: in iterations over the two ends of the
  // overlap, each leaves the error times yield(ends)^2/(yield(one) yield(other)).
  const auto yield = [=](double y, double z) {
    return 1 / first.mass + 1 / second.mass + (a + y) * (a + z) / first.inertia + (y - b) * (z - b) / second.inertia;
  };
  const double upper = side / 2 - a;
  const double lower = b - side / 2;
  const double rate = yield(upper, lower) * yield(upper, lower) / (yield(upper, upper) * yield(lower, lower));
  const auto share = [=, e = p.at("restitution")](const Stepping& s) {
    const double slow = v < s.restitution_threshold ? e : 0;
    return slow + (s.iterations > 0 ? std::pow(rate, s.iterations) : 0);
  };
  std::vector<Expectation> all;
  for (const bool flies : {true, false}) {
    const std::string name = flies ? "flies" : "struck";
    const double velocity = flies ? v - blow / first.mass : blow / second.mass;
    const double jump = blow / (flies ? first.mass : second.mass);
    const double start = flies ? -side : 0;
    const auto speed = [=](const Stepping& s) {
      return jump * share(s) + round_off(s, duration, 2 * (side + v) + jump);
    };
    const auto place = [=](const Stepping& s) { return jump * found_off(s, v) + left * speed(s) + speed(s); };
    const auto turns = [=](const Stepping& s) {
      return 6 / side * jump * share(s) + 6 / side * round_off(s, duration, 2 * (side + v) + jump);
    };
    all.push_back({.body = name,
                   .quantity = Quantity::vx,
                   .expected = velocity,
                   .allowed = speed,
                   .source = "J = (1 + e) v/(1/m1 + 1/m2 + a^2/I1 + b^2/I2), whenever the impact is found"});
    all.push_back({.body = name,
                   .quantity = Quantity::angular_velocity,
                   .expected = spin,
                   .allowed = turns,
                   .source = "both turn alike, a J/I1 = b J/I2: the faces stay parallel"});
    all.push_back({.body = name,
                   .quantity = Quantity::x,
                   .expected = start + velocity * left,
                   .allowed = place,
                   .source = "the velocity jump times the time by which the impact is found late or early"});
    all.push_back({.body = name,
                   .quantity = Quantity::angle,
                   .expected = spin * left,
                   .allowed = [=](const Stepping& s) { return spin * found_off(s, v) + 2 * turns(s); },
                   .source = "the spin times the time since the impact, which may be found late or early"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "box-on-box",
     .question = "Do two free boxes that meet flat exchange their momentum, and turn alike if they meet half?",
     .parameters =
         {{.name = "offset", .value = 0, .min = 0, .max = 0.5, .unit = "m", .about = "of the struck box, across"},
          {.name = "speed", .value = 3, .min = 1.5, .max = 4, .unit = "m/s", .about = "of the approach"},
          {.name = "ratio", .value = 1, .min = 0.2, .max = 5, .about = "mass of the struck box divided by the other's"},
          {.name = "restitution", .value = 0.5, .min = 0.2, .max = 1, .about = "of both boxes"}},
     .variants = {{"square", {}},
                  {"heavy", {{"ratio", 5}, {"restitution", 1}}},
                  {"half", {{"offset", 0.5}}},
                  {"half heavy", {{"offset", 0.5}, {"ratio", 4}, {"restitution", 0.8}}}},
     .closed_form = "line",
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::box_on_box
