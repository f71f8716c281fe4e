#include <cmath>
#include <numbers>

#include "scenarios/joints/swing.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

// A rod hinged at one end to the world and released at rest: a pendulum or, from near upright, a toppling rod.
namespace plumb::scenarios::hinged_rod {
namespace {

constexpr double gravity = 10;     // m/s^2
constexpr double thickness = 0.1;  // m

// Length, m; angle from the downward vertical, rad; duration, s.
Scene rod_scene(double length, double angle, double duration) {
  Scene scene{.gravity = {0, -gravity}, .duration = duration};
  const Body pivot{.name = "pivot", .type = BodyType::fixed, .layers = 1};
  Body rod = box("rod", {length / 2 * std::sin(angle), -length / 2 * std::cos(angle)}, {length, thickness}, {});
  rod.angle = angle - std::numbers::pi / 2;
  rod.layers = 2;
  scene.bodies = {pivot, rod};
  scene.joints.push_back(Revolute{.a = 0, .b = 1});
  return scene;
}

// Angle and position of the rod at a sixth of the run, when a first-order method must still be good, and at the end;
// and its energy at the end.
std::vector<Expectation> rod_expectations(double length, double angle, double duration) {
  const Mass mass = mass_of(rod_scene(length, angle, duration).bodies[1]);
  const double d = length / 2;
  const double inertia = mass.inertia + mass.mass * d * d;
  const HingedRod rod{angle, d, mass.mass * gravity, inertia, mass.mass * d * d / inertia};
  std::vector<Expectation> all;
  for (const double time : {std::floor(60 * duration / 6) / 60, duration}) {
    const auto turn = [=](const Stepping& s) { return rod.turn(s, time); };
    const auto place = [=](const Stepping& s) { return d * rod.turn(s, time) + s.joint_slop; };
    all.push_back({.body = "rod",
                   .quantity = Quantity::angle,
                   .time = time,
                   .allowed = turn,
                   .source = "sin(a/2) = k cd(w t); the method's phase error"});
    for (const Quantity along : {Quantity::x, Quantity::y}) {
      all.push_back({.body = "rod",
                     .quantity = along,
                     .time = time,
                     .allowed = place,
                     .source = "on the circle about the pivot; d times the angle's error"});
    }
  }
  all.push_back({.quantity = Quantity::energy,
                 .allowed = [=](const Stepping& s) { return rod.energy(s, duration); },
                 .source = "constant; what a hinge loses, and the method's own oscillation"});
  return all;
}

}  // namespace
}  // namespace plumb::scenarios::hinged_rod

namespace plumb::scenarios::pendulum {
namespace {

constexpr double duration = 3;  // s

Scene scene(const Parameters& p) {
  Scene scene = hinged_rod::rod_scene(p.at("length"), p.at("angle") * degree, duration);
  scene.name = "pendulum";
  scene.about = "A rod swings on a frictionless pivot.";
  return scene;
}

std::vector<Expectation> expectations(const Parameters& p) {
  return hinged_rod::rod_expectations(p.at("length"), p.at("angle") * degree, duration);
}

const Catalog<Scenario>::Entry entry{
    {.name = "pendulum",
     .question = "Does a pendulum's period grow with its amplitude as the elliptic integral says?",
     .parameters = {{.name = "length", .value = 2, .min = 0.5, .max = 10, .unit = "m", .about = "of the rod"},
                    {.name = "angle",
                     .value = 90,
                     .min = -90,
                     .max = 90,
                     .unit = "deg",
                     .about = "of release, from the downward vertical"}},
     .variants = {{"small", {{"angle", 10}}}, {"wide", {}}},
     .closed_form = "pendulum",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::pendulum

namespace plumb::scenarios::rod_toppling {
namespace {

constexpr double duration = 1;  // s, after which a rod of 4 m is about horizontal

double angle_of(const Parameters& p) { return (180 - p.at("lean")) * degree; }

Scene scene(const Parameters& p) {
  Scene scene = hinged_rod::rod_scene(p.at("length"), angle_of(p), duration);
  scene.name = "rod-toppling";
  scene.about = "A rod that stands on a pivot topples over.";
  return scene;
}

std::vector<Expectation> expectations(const Parameters& p) {
  return hinged_rod::rod_expectations(p.at("length"), angle_of(p), duration);
}

const Catalog<Scenario>::Entry entry{
    {.name = "rod-toppling",
     .question = "Does a toppling rod turn with w^2 = (3 g/L)(cos b0 - cos b)?",
     .parameters =
         {{.name = "length", .value = 4, .min = 1, .max = 20, .unit = "m", .about = "of the rod"},
          {.name = "lean", .value = 15, .min = 1, .max = 80, .unit = "deg", .about = "of release, from the upright"}},
     .variants = {{"15deg", {}}},
     .closed_form = "pendulum",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::rod_toppling

namespace plumb::scenarios::double_pendulum {
namespace {

constexpr double length = 1;   // m, of each rod
constexpr double thick = 0.1;  // m

// Both rods in one line, at `angle` from the downward vertical, at rest.
Scene scene(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const Vec along{std::sin(angle), -std::cos(angle)};
  Scene scene{.name = "double-pendulum", .about = "One rod hangs from another.", .duration = p.at("duration")};
  scene.bodies.push_back({.name = "pivot", .type = BodyType::fixed, .layers = 0});
  for (int i = 1; i <= 2; ++i) {
    const double distance = (i - 0.5) * length;
    Body rod = box(i == 1 ? "upper" : "lower", {distance * along.x, distance * along.y}, {thick, length}, {});
    rod.angle = angle;
    rod.layers = 0;
    scene.bodies.push_back(rod);
  }
  scene.joints = {Revolute{.a = 0, .b = 1}, Revolute{.a = 1, .b = 2, .anchor = {length * along.x, length * along.y}}};
  return scene;
}

const Catalog<Scenario>::Entry entry{
    {.name = "double-pendulum",
     .question = "Does a double pendulum keep swinging without gaining energy?",
     .parameters = {{.name = "angle",
                     .value = 120,
                     .min = 1,
                     .max = 179,
                     .unit = "deg",
                     .about = "of both rods from the downward vertical, at the start"},
                    {.name = "duration", .value = 5, .min = 0.1, .max = 100, .unit = "s", .about = "of the run"}},
     .variants = {{"small", {{"angle", 5}}}, {"wild", {}}},
     .scene = scene,
     .expectations = [](const Parameters&) { return std::vector<Expectation>{}; }}};

}  // namespace
}  // namespace plumb::scenarios::double_pendulum
