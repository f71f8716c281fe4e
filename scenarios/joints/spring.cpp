#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::spring {
namespace {

constexpr double length = 2;    // m
constexpr double duration = 5;  // s

Scene scene(const Parameters& p) {
  Scene scene{.name = "spring",
              .about = "A disc on a spring oscillates along a line.",
              .gravity = {0, 0},
              .duration = duration};
  scene.bodies.push_back(disc("disc", {length + p.at("amplitude"), 0}, 0.25, {}));
  const double mass = mass_of(scene.bodies[0]).mass;
  const double w = p.at("frequency");
  scene.forces.push_back(Spring{.b = 0, .stiffness = mass * w * w, .length = length});
  return scene;
}

// Errors of a method for x'' = -w^2 x, relative to the amplitude. Forces are evaluated at intervals of f, k = w f:
//   first      symplectic Euler (drift > 0) gives x half a step late or, if it moves first (drift < 0), early, and v
//              exactly: x_n = A cos((n +- 1/2) q)/cos(q/2), v_n = -A w' sin(n q). So x is off by |drift| w h. If
//              several sub-steps use the same force, v is off by |drift| w (f - h). The energy is off by
//              |drift| k w x v, at most |drift| k of it;
//   growth     a method that keeps no spring bounded multiplies the energy by at most 1 + k^2 per step;
//   frequency  (2/f) asin(k/2), of Verlet and both of the above: a phase of k^2/24 w t ahead, up to terms of k^4;
//   second     v is off by k^2/8, and the energy by k^2/4: Verlet keeps v^2 + w^2 (1 - k^2/4) x^2.
struct SpringErrors {
  double place = 0, speed = 0, energy = 0;
};

SpringErrors spring_errors(const Stepping& s, double w) {
  if (s.h == 0) return {};
  const double k = w * force_interval(s);
  const double first = std::abs(s.drift) * w;
  const double w_dt = w * s.dt;
  const double grown = grows(s) ? std::pow(1 + w_dt * w_dt, duration / (2 * s.dt)) - 1 : 0;
  const double common = grown + k * k / 24 * w * duration * (1 + k * k) + k * k / 8;
  const double held = std::max(force_interval(s) - s.h, 0.0);  // s, for which a force is the same in later sub-steps
  return {common + first * s.h, common + first * held, std::abs(s.drift) * k + k * k / 4 + grown * (2 + grown)};
}

std::vector<Expectation> expectations(const Parameters& p) {
  const double a = p.at("amplitude");
  const double w = p.at("frequency");
  const double mass = mass_of(scene(p).bodies[0]).mass;
  const double energy = mass * w * w * a * a / 2;
  const double speed = a * w;
  const auto round = [=](const Stepping& s) { return round_off(s, duration, length + a + speed * duration); };
  return {
      {.body = "disc",
       .quantity = Quantity::x,
       .allowed = [=](const Stepping& s) { return a * spring_errors(s, w).place + round(s); },
       .source = "A cos(w t); half a step off, or its growth, and a phase of k^2/24 w t"},
      {.body = "disc",
       .quantity = Quantity::vx,
       .allowed = [=](const Stepping& s) { return speed * spring_errors(s, w).speed + w * round(s); },
       .source = "-A w sin(w t); a phase of k^2/24 w t"},
      {.quantity = Quantity::energy,
       .allowed = [=](const Stepping& s) { return energy * spring_errors(s, w).energy + mass * w * speed * round(s); },
       .source = "constant; the method keeps an energy that differs by k w x v/2, or by k^2/4"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "spring",
     .question = "Does a mass on a spring oscillate at sqrt(k/m) and keep its energy as well as the method can?",
     .parameters = {{.name = "frequency", .value = 4, .min = 0.1, .max = 60, .unit = "rad/s", .about = "sqrt(k/m)"},
                    {.name = "amplitude", .value = 1, .min = 0.01, .max = 1.5, .unit = "m", .about = "at the start"}},
     .variants = {{"w=4", {}}, {"w=15", {{"frequency", 15}}}},
     .closed_form = "spring",
     .scene = scene,
     .expectations = expectations,
     .smoothness = [](const Parameters&) { return Smoothness::free; }}};

}  // namespace
}  // namespace plumb::scenarios::spring

namespace plumb::scenarios::beats {
namespace {

constexpr double apart = 2;         // m, between the discs at rest, and from each to its wall
constexpr double duration = 5;      // s
constexpr double exchanged = 3.15;  // s, about when the other disc has all the energy: pi/(w2 - w1)

// w1 = sqrt(k/m) if both swing alike, w2 = sqrt((k + 2c)/m) if they swing against each other.
Scene scene(const Parameters& p) {
  Scene scene{.name = "beats",
              .about = "Two discs on springs, coupled by a third spring.",
              .gravity = {0, 0},
              .duration = duration};
  scene.bodies.push_back(disc("struck", {p.at("amplitude"), 0}, 0.25, {}));
  scene.bodies.push_back(disc("coupled", {apart, 0}, 0.25, {}));
  const double mass = mass_of(scene.bodies[0]).mass;
  const double alike = p.at("alike");
  const double against = alike * p.at("ratio");
  const double wall = mass * alike * alike;
  const double between = mass * (against * against - alike * alike) / 2;
  scene.forces = {Spring{.b = 0, .anchor_a = {-apart, 0}, .stiffness = wall, .length = apart},
                  Spring{.b = 1, .anchor_a = {2 * apart, 0}, .stiffness = wall, .length = apart},
                  Spring{.a = 0, .b = 1, .stiffness = between, .length = apart}};
  return scene;
}

// x = A/2 (cos w1 t +- cos w2 t): each mode is a mass on a spring of its own, with its errors.
std::vector<Expectation> expectations(const Parameters& p) {
  const double a = p.at("amplitude");
  const double w1 = p.at("alike");
  const double w2 = w1 * p.at("ratio");
  const double mass = mass_of(scene(p).bodies[0]).mass;
  const double energy = mass * (w1 * w1 + w2 * w2) * a * a / 4;
  const double fastest = a * (w1 + w2) / 2;
  const auto round = [=](const Stepping& s) { return round_off(s, duration, 2 * apart + a + fastest * duration); };
  const auto place = [=](const Stepping& s) {
    return a / 2 * (spring::spring_errors(s, w1).place + spring::spring_errors(s, w2).place) + round(s);
  };
  std::vector<Expectation> all;
  for (const double t : {exchanged, duration}) {
    for (const double sign : {1.0, -1.0}) {
      all.push_back({.body = sign > 0 ? "struck" : "coupled",
                     .quantity = Quantity::x,
                     .time = t,
                     .expected = (sign > 0 ? 0 : apart) + a / 2 * (std::cos(w1 * t) + sign * std::cos(w2 * t)),
                     .allowed = place,
                     .source = "A/2 (cos w1 t +- cos w2 t); the errors of a spring, in each mode"});
    }
  }
  all.push_back({.quantity = Quantity::energy,
                 .expected = energy,
                 .allowed =
                     [=](const Stepping& s) {
                       return energy * spring::spring_errors(s, w2).energy + mass * w2 * fastest * round(s);
                     },
                 .source = "constant; the method keeps an energy that differs by k w x v/2, or by k^2/4"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "beats",
     .question = "Do two coupled oscillators hand their energy to each other and back?",
     .parameters =
         {{.name = "alike", .value = 4, .min = 1, .max = 10, .unit = "rad/s", .about = "mode of both together"},
          {.name = "ratio",
           .value = 1.25,
           .min = 1,
           .max = 4,
           .about = "of the mode of each against the other to that"},
          {.name = "amplitude", .value = 0.6, .min = 0.01, .max = 1, .unit = "m", .about = "at the start, of one"}},
     .variants = {{"weak coupling", {}}, {"strong", {{"alike", 3}, {"ratio", 3}}}},
     .scene = scene,
     .expectations = expectations,
     .smoothness = [](const Parameters&) { return Smoothness::free; }}};

}  // namespace
}  // namespace plumb::scenarios::beats

namespace plumb::scenarios::spring_ellipse {
namespace {

constexpr double duration = 5;  // s
constexpr Vec center{1, -0.5};  // m
constexpr double turned = 0.4;  // rad, of the ellipse's axes

Vec in_world(double major, double minor) {
  return {center.x + std::cos(turned) * major - std::sin(turned) * minor,
          center.y + std::sin(turned) * major + std::cos(turned) * minor};
}

// A spring without a length of its own pulls with k r.
Scene scene(const Parameters& p) {
  Scene scene{.name = "spring-ellipse",
              .about = "A disc circles the other end of a spring that has no length of its own.",
              .gravity = {0, 0},
              .duration = duration};
  const double w = p.at("frequency");
  Body planet = disc("disc", in_world(p.at("major"), 0), 0.25, {});
  planet.velocity = {-std::sin(turned) * w * p.at("minor"), std::cos(turned) * w * p.at("minor")};
  const double mass = mass_of(planet).mass;
  scene.bodies.push_back(planet);
  scene.forces.push_back(Spring{.b = 0, .anchor_a = center, .stiffness = mass * w * w});
  return scene;
}

// r = (a cos w t, b sin w t): an ellipse about the spring's end (Newton, Principia, Prop. 10). Both coordinates are
// springs. The sine starts with a speed, and first-order methods are half a step off in that as the cosine is in place.
std::vector<Expectation> expectations(const Parameters& p) {
  const double a = p.at("major");
  const double b = p.at("minor");
  const double w = p.at("frequency");
  const double mass = mass_of(scene(p).bodies[0]).mass;
  const double phase = w * duration;
  const Vec end = in_world(a * std::cos(phase), b * std::sin(phase));
  const double energy = mass * w * w * (a * a + b * b) / 2;
  const auto round = [=](const Stepping& s) { return round_off(s, duration, 2 + (a + b) * (1 + phase)); };
  const auto place = [=](const Stepping& s) { return (a + b) * spring::spring_errors(s, w).place + round(s); };
  return {{.body = "disc",
           .quantity = Quantity::x,
           .expected = end.x,
           .allowed = place,
           .source = "(a cos w t, b sin w t); half a step off, a phase of k^2/24 w t"},
          {.body = "disc",
           .quantity = Quantity::y,
           .expected = end.y,
           .allowed = place,
           .source = "(a cos w t, b sin w t); half a step off, a phase of k^2/24 w t"},
          {.quantity = Quantity::energy,
           .expected = energy,
           .allowed =
               [=](const Stepping& s) {
                 return energy * spring::spring_errors(s, w).energy + mass * w * w * (a + b) * round(s);
               },
           .source = "constant; the method keeps an energy that differs by k w x v/2, or by k^2/4"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "spring-ellipse",
     .question = "Does a disc on a spring without length run on an ellipse about the spring's end?",
     .parameters =
         {{.name = "frequency", .value = 4, .min = 0.1, .max = 20, .unit = "rad/s", .about = "sqrt(k/m)"},
          {.name = "major", .value = 1.5, .min = 0.1, .max = 5, .unit = "m", .about = "half the long axis"},
          {.name = "minor", .value = 0.7, .min = 0.05, .max = 5, .unit = "m", .about = "half the short axis"}},
     .variants = {{"ellipse", {}}},
     .scene = scene,
     .expectations = expectations,
     .smoothness = [](const Parameters&) { return Smoothness::free; }}};

}  // namespace
}  // namespace plumb::scenarios::spring_ellipse
