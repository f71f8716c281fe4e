#include <cmath>
#include <utility>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::lone_bodies {
namespace {

constexpr double duration = 1;    // s
constexpr double gravity = 10;    // m/s^2
constexpr double pitch = 20;      // m, from body to body: they never collide
constexpr double scale = 0.5;     // of gravity
constexpr double pull = 3;        // m/s^2, force per mass
constexpr double turn = 2;        // rad/s^2, torque per inertia
constexpr double whisper = 0.05;  // m/s^2, a tiny force per mass: less than 1 mm/s per step
constexpr double start = 4;       // m/s and rad/s, initial velocities
constexpr double density = 3;     // kg/m^2; not 1, so that mass and area differ

enum Which : std::size_t { light, pushed, slow, upright, damped, bent };

// An L of two boxes, one twice as dense as the other. The body frame is the first box's.
Body bent_body() {
  Body made = box("bent", {static_cast<double>(bent) * pitch, 0}, {1, 0.5}, surface(0.5, 0, density));
  made.shapes.push_back(
      {.geometry = Box{.size = {0.5, 1}, .center = {0.75, 0.25}}, .surface = surface(0.5, 0, 2 * density)});
  made.gravity_scale = 0;
  made.angular_velocity = start;
  return made;
}

Vec start_of(Which which) { return {static_cast<double>(which) * pitch, 0}; }

Scene scene(const Parameters& p) {
  Scene scene{.name = "lone-bodies",
              .about = "Bodies far apart, each moved by something different.",
              .gravity = {0, -gravity},
              .duration = duration};
  for (const auto& [which, name] : {std::pair{light, "light"}, std::pair{pushed, "pushed"}, std::pair{slow, "slow"},
                                    std::pair{upright, "upright"}, std::pair{damped, "damped"}}) {
    Body one = box(name, start_of(which), {1, 0.5}, surface(0.5, 0, density));
    one.gravity_scale = which == light ? scale : 0;
    scene.bodies.push_back(one);
  }
  const Mass mass = mass_of(scene.bodies[pushed]);
  scene.forces.push_back(Constant{.body = pushed, .force = {pull * mass.mass, 0}, .torque = turn * mass.inertia});
  scene.forces.push_back(Constant{.body = slow, .force = {whisper * mass.mass, 0}});
  scene.forces.push_back(Constant{.body = upright, .torque = turn * mass.inertia});
  scene.bodies[upright].fixed_rotation = true;
  Body& air = scene.bodies[damped];
  air.velocity = {start, 0};
  air.angular_velocity = start;
  air.linear_damping = air.angular_damping = p.at("damping");
  scene.bodies.push_back(bent_body());
  scene.forces.push_back(Constant{.body = bent, .torque = turn * mass_of(scene.bodies[bent]).inertia});
  return scene;
}

// Constant accelerations: off by the drift a t h. Damping c: v0 e^(-ct).
std::vector<Expectation> expectations(const Parameters& p) {
  const double t = duration;
  const double c = p.at("damping");
  const double reach = 5 * pitch + gravity * t;
  const auto exact = [=](const Stepping& s) { return round_off(s, t, reach); };
  const auto drift = [=](double a) { return [=](const Stepping& s) { return drifted(s, a, t) + exact(s); }; };
  const auto slower = [=](const Stepping& s) {
    return start * std::exp(-c * t) * std::expm1(damping_error(s, c) * t) + exact(s);
  };
  const auto distance = [=](const Stepping& s) { return damped_way_error(s, c, start, t) + exact(s); };
  const Vec corner = mass_of(bent_body()).center;
  const double left = std::exp(-c * t);
  const double gone = start * (1 - left) / c;
  return {{.body = "light",
           .quantity = Quantity::y,
           .expected = -scale * gravity * t * t / 2,
           .allowed = drift(scale * gravity),
           .source = "gravity scale times g t^2/2; drift"},
          {.body = "pushed",
           .quantity = Quantity::x,
           .expected = start_of(pushed).x + pull * t * t / 2,
           .allowed = drift(pull),
           .source = "F/m t^2/2; drift"},
          {.body = "pushed", .quantity = Quantity::y, .expected = 0, .allowed = exact, .source = "no gravity"},
          {.body = "pushed",
           .quantity = Quantity::angle,
           .expected = turn * t * t / 2,
           .allowed = drift(turn),
           .source = "T/I t^2/2; drift"},
          {.body = "slow",
           .quantity = Quantity::x,
           .expected = start_of(slow).x + whisper * t * t / 2,
           .allowed = drift(whisper),
           .source = "F/m t^2/2, however small the force; drift"},
          {.body = "upright",
           .quantity = Quantity::angle,
           .expected = 0,
           .allowed = exact,
           .source = "a body with fixed rotation does not turn"},
          {.body = "damped",
           .quantity = Quantity::vx,
           .expected = start * left,
           .allowed = slower,
           .source = "v0 e^(-ct); c^2 t h/2, or c^3 t h^2/12 of it"},
          {.body = "damped",
           .quantity = Quantity::x,
           .expected = start_of(damped).x + gone,
           .allowed = distance,
           .source = "v0 (1 - e^(-ct))/c; t times the error of v"},
          {.body = "damped",
           .quantity = Quantity::angular_velocity,
           .expected = start * left,
           .allowed = slower,
           .source = "w0 e^(-ct); c^2 t h/2, or c^3 t h^2/12 of it"},
          {.body = "bent",
           .quantity = Quantity::x,
           .expected = start_of(bent).x + corner.x,
           .allowed = exact,
           .source = "turns about its centre of mass, which stays in place"},
          {.body = "bent",
           .quantity = Quantity::y,
           .expected = corner.y,
           .allowed = exact,
           .source = "turns about its centre of mass, which stays in place"},
          {.body = "bent",
           .quantity = Quantity::angle,
           .expected = start * t + turn * t * t / 2,
           .allowed = drift(turn),
           .source = "w0 t + T/I t^2/2, I by parallel axes; drift"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "lone-bodies",
     .question = "Does a lone body respond correctly to each influence: gravity scale, forces, torques, damping?",
     .parameters = {{.name = "damping",
                     .value = 0.8,
                     .min = 0.1,
                     .max = 5,
                     .unit = "1/s",
                     .about = "linear and angular damping of one of them"}},
     .variants = {{"each", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::lone_bodies
