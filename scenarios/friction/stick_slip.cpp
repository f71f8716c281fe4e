#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::stick_slip {
namespace {

constexpr double gravity = 10;              // m/s^2
constexpr double length = 3;                // m, of the spring at rest
constexpr Vec size{1, 0.5};                 // m; too low to tip: mu < b/h = 2
constexpr double w = 2 * std::numbers::pi;  // rad/s, of block and spring
constexpr int slips = 3;

// Popp & Stelter, Phil. Trans. R. Soc. A 332 (1990). A puller at the speed V draws the spring out by d. The block
// sticks up to d = s = mu_s g/w^2. It slips about the middle d = m = mu_d g/w^2: with D = s - m,
//   d = m + D cos(w t) + V/w sin(w t)
// until it is at rest again, d' = V: after 2 (pi - atan(w D/V))/w, at d = m - D. Then it sticks for 2 D/V.
struct Cycle {
  double speed, middle, beyond;  // m/s, m, m: V, m, D

  explicit Cycle(const Parameters& p)
      : speed(p.at("speed")), middle(p.at("dynamic") * gravity / (w * w)), beyond(p.at("excess") * gravity / (w * w)) {}

  double sticks() const { return 2 * beyond / speed; }
  double slides() const { return 2 * (std::numbers::pi - std::atan(w * beyond / speed)) / w; }
  double period() const { return sticks() + slides(); }
  // s, the middle of its n-th rest.
  double rest(int n) const { return n * period() + sticks() / 2; }
  // m, where the block is, t seconds after it began to slip.
  double way(double t) const { return speed * t + beyond * (1 - std::cos(w * t)) - speed / w * std::sin(w * t); }
  double slip() const { return speed * period(); }
};

// It starts as after a slip.
Scene scene(const Parameters& p) {
  const Cycle cycle(p);
  Surface rough = surface(p.at("dynamic"), 0);
  rough.static_friction = p.at("dynamic") + p.at("excess");
  Scene scene{.name = "stick-slip",
              .about = "A spring that is drawn out at a constant speed pulls a block over rough ground.",
              .gravity = {0, -gravity},
              .duration = whole_steps(cycle.rest(slips))};
  Body puller{.name = "puller",
              .type = BodyType::kinematic,
              .position = {length + cycle.middle - cycle.beyond, size.y / 2},
              .velocity = {cycle.speed, 0},
              .layers = 0};
  scene.bodies = {level_ground(rough), box("block", {0, size.y / 2}, size, rough), puller};
  scene.forces.push_back(Spring{.a = 2, .b = 1, .stiffness = mass_of(scene.bodies[1]).mass * w * w, .length = length});
  return scene;
}

// With k = w f, f the interval of forces, each slip is off by
//   onset    it begins up to a step late, drawn out by V h more: 2 V h of its way, and as much of V times its time,
//            whose derivative by D is at most 2/V;
//   stop     a step's way at the deceleration w^2 D, w^2 D h^2;
//   method   half a step at the puller's speed if it is of first order; k^2/4 of the swing in the energy, and k^2/24 of
//            its time.
// Each moves where the block rests, and the time of all that follows by that over V. While it slips for the first time
// only the onset counts: a step late of a way that is fastest then, and drawn out by V h more, of which it goes at most
// twice as much. Contact is found a lag late, mu times the slop is missing while the block sinks in, and it may creep.
std::vector<Expectation> expectations(const Parameters& p) {
  const Cycle cycle(p);
  const double mu = p.at("dynamic") + p.at("excess");
  const double end = cycle.rest(slips);
  const double swing = std::hypot(cycle.beyond, cycle.speed / w);
  const auto method = [=](const Stepping& s) {
    const double k = w * force_interval(s);
    const double first = first_order(s) ? cycle.speed * s.h : 0;
    const double grown = grows(s) ? swing * (std::pow(1 + k * k, cycle.slides() / (2 * force_interval(s))) - 1) : 0;
    return first + swing * k * k * (1.0 / 4 + w * cycle.slides() / 24) + grown;
  };
  const auto contact = [=](const Stepping& s) {
    return slid_late(s, mu * gravity) + mu * s.slop + s.creep * end + size.y / size.x * s.contact_gap() +
           round_off(s, end, length + cycle.slip() * slips * (1 + w * end));
  };
  const auto off = [=](const Stepping& s, int n) {
    return n * (4 * cycle.speed * s.h + w * w * cycle.beyond * s.h * s.h + method(s)) + contact(s);
  };
  const double middle = cycle.sticks() + cycle.slides() / 2;  // of the first slip: it is fastest there
  const double fastest = cycle.speed + swing * w;
  std::vector<Expectation> all{
      {.body = "block",
       .quantity = Quantity::x,
       .time = middle,
       .expected = cycle.way(cycle.slides() / 2),
       .allowed = [=](const Stepping& s) { return (fastest + 2 * cycle.speed) * s.h + method(s) + contact(s); },
       .source = "V t + D (1 - cos w t) - V/w sin w t while it slips; late by the onset"}};
  for (int n = 1; n <= slips; ++n) {
    all.push_back({.body = "block",
                   .quantity = Quantity::x,
                   .time = cycle.rest(n),
                   .expected = n * cycle.slip(),
                   .allowed = [=](const Stepping& s) { return off(s, n); },
                   .source = "slips V times the period, 2 D/V + 2 (pi - atan(w D/V))/w"});
  }
  all.push_back({.body = "block",
                 .quantity = Quantity::vx,
                 .expected = 0,
                 .allowed =
                     [=](const Stepping& s) {
                       const double f = force_interval(s);
                       return w * w * cycle.speed * f * f + s.creep + still_sinking(s, mu, end) +
                              round_off(s, end, length + cycle.speed * end);
                     },
                 .source = "sticks; creep, and what the pull grows by in a step"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "stick-slip",
     .question = "Does a block on a spring that is drawn out stick and slip with the right period and way?",
     .parameters = {{.name = "dynamic", .value = 0.3, .min = 0.2, .max = 0.5, .about = "friction while it slips"},
                    {.name = "excess",
                     .value = 0.3,
                     .min = 0.15,
                     .max = 0.5,
                     .about = "of the friction while it sticks over that"},
                    {.name = "speed", .value = 0.2, .min = 0.1, .max = 0.4, .unit = "m/s", .about = "of the puller"}},
     .variants = {{"slow", {}}, {"fast", {{"speed", 0.4}, {"excess", 0.2}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::stick_slip
