#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

// A disc hits a rod on its side, beside the rod's centre, without friction or gravity.
namespace plumb::scenarios::struck_rod {
namespace {

constexpr double longest = 0.8;    // s, of a run
constexpr double moment = 0.393;   // s, of the impact: between two steps
constexpr double length = 2;       // m, of the rod
constexpr double thickness = 0.2;  // m
constexpr double radius = 0.25;    // m, of the disc

// The rod lies along x with its centre at the origin; the disc comes from below, `beside` the centre.
Scene struck(const Parameters& p, double beside) {
  Scene scene{.gravity = {0, 0}, .duration = longest};
  const Surface smooth = surface(0, p.at("restitution"));
  Body rod = box("rod", {0, 0}, {length, thickness}, smooth);
  const double area = std::numbers::pi * radius * radius;
  Body striker = disc("disc", {beside, -thickness / 2 - radius - p.at("speed") * moment}, radius,
                      surface(0, p.at("restitution"), p.at("ratio") * mass_of(rod).mass / area));
  striker.velocity = {0, p.at("speed")};
  scene.bodies = {rod, striker};
  return scene;
}

// The line of the impact is the rod's normal wherever the disc touches it, and the arm is the disc's place along the
// rod: neither depends on when the impact is found. So velocities are exact, and positions off by their jump times the
// time by which it is found late or early, and by the overlap that may be removed.
struct Allowed {
  double approach, reach;

  double exact(const Stepping& s) const { return round_off(s, longest, reach); }
  double overlap(const Stepping& s) const { return approach * lag(s) + s.contact_gap(); }
  double place(const Stepping& s, double jump) const {
    return std::abs(jump) * found_off(s, approach) + overlap(s) + exact(s);
  }
};

}  // namespace
}  // namespace plumb::scenarios::struck_rod

namespace plumb::scenarios::rod_hit {
namespace {

// What the blow does to the rod.
struct Blow {
  double impulse, spin;  // N s, rad/s
};

// J = (1+e) v/(1/m1 + 1/m2 + d^2/I).
Blow blow(const Scene& scene, const Parameters& p) {
  const Mass rod = mass_of(scene.bodies[0]);
  const Mass striker = mass_of(scene.bodies[1]);
  const double d = p.at("offset");
  const double impulse =
      (1 + p.at("restitution")) * p.at("speed") / (1 / striker.mass + 1 / rod.mass + d * d / rod.inertia);
  return {impulse, d * impulse / rod.inertia};
}

// It ends before the other end of the rod comes round to the disc: in 1.2 rad and a step it never does.
Scene scene(const Parameters& p) {
  Scene scene = struck_rod::struck(p, p.at("offset"));
  scene.name = "rod-hit";
  scene.about = "A disc hits a free rod on its side.";
  constexpr double most_turn = 1.2;  // rad
  const double last = struck_rod::moment + most_turn / blow(scene, p).spin;
  scene.duration = std::min(struck_rod::longest, whole_steps(last));
  return scene;
}

// Overlap that is removed at the distance d from the rod's centre turns it by at
// most 1/(2 k) times it, k^2 = I/m.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene built = scene(p);
  const Mass rod = mass_of(built.bodies[0]);
  const Mass striker = mass_of(built.bodies[1]);
  const double v = p.at("speed");
  const double impulse = blow(built, p).impulse;
  const double spin = blow(built, p).spin;
  const double duration = built.duration;
  const double after = duration - struck_rod::moment;
  const double rises = impulse / rod.mass;
  const double slower = impulse / striker.mass;
  const struck_rod::Allowed allowed{v, 2 * (struck_rod::length + v + std::abs(spin))};
  const auto exact = [=](const Stepping& s) { return allowed.exact(s); };
  const double radius_of_gyration = std::sqrt(rod.inertia / rod.mass);
  const auto turn = [=](const Stepping& s) {
    return std::abs(spin) * found_off(s, v) + allowed.overlap(s) / (2 * radius_of_gyration) + exact(s);
  };
  return {
      {.body = "rod",
       .quantity = Quantity::vy,
       .expected = rises,
       .allowed = exact,
       .source = "J/m, J = (1+e) v/(1/m1 + 1/m2 + d^2/I); neither depends on when the impact is found"},
      {.body = "rod", .quantity = Quantity::angular_velocity, .expected = spin, .allowed = exact, .source = "d J/I"},
      {.body = "disc", .quantity = Quantity::vy, .expected = v - slower, .allowed = exact, .source = "v - J/m"},
      {.body = "rod",
       .quantity = Quantity::y,
       .expected = rises * after,
       .allowed = [=](const Stepping& s) { return allowed.place(s, rises); },
       .source = "the velocity jump times the lag, and the overlap"},
      {.body = "rod",
       .quantity = Quantity::angle,
       .expected = spin * after,
       .allowed = turn,
       .source = "the jump of the spin times the lag, and the overlap"},
      {.body = "disc",
       .quantity = Quantity::y,
       .expected = built.bodies[1].position.y + v * duration - slower * after,
       .allowed = [=](const Stepping& s) { return allowed.place(s, slower); },
       .source = "the velocity jump times the lag, and the overlap"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "rod-hit",
     .question = "Does a free rod that is struck beside its centre get the right velocity and spin?",
     .parameters =
         {{.name = "offset", .value = 0.6, .min = 0, .max = 0.9, .unit = "m", .about = "of the disc from the centre"},
          {.name = "speed", .value = 3, .min = 1.5, .max = 6, .unit = "m/s", .about = "of the disc"},
          {.name = "ratio", .value = 1, .min = 0.1, .max = 10, .about = "mass of the disc divided by that of the rod"},
          {.name = "restitution", .value = 0.5, .min = 0.2, .max = 1, .about = "of disc and rod"}},
     .variants = {{"e=0.5", {}},
                  {"e=1", {{"restitution", 1}, {"offset", 0.3}, {"ratio", 2}}},
                  {"at the end", {{"offset", 0.9}, {"ratio", 0.3}}}},
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::rod_hit

namespace plumb::scenarios::hinged_hit {
namespace {

using struck_rod::length;
using struck_rod::longest;

constexpr double after = longest - struck_rod::moment;

// m, from the hinge: I_p/(m l/2), the centre of percussion. A blow there makes the free rod turn about its end.
constexpr double sweet_spot =
    length / 2 + (length * length + struck_rod::thickness * struck_rod::thickness) / (6 * length);

Scene scene(const Parameters& p) {
  Scene scene = struck_rod::struck(p, p.at("distance") - length / 2);
  scene.name = "hinged-hit";
  scene.about = "A disc hits a rod that is hinged at one end.";
  Body pivot{.name = "pivot", .type = BodyType::fixed, .position = {-length / 2, 0}, .layers = 0};
  scene.bodies.push_back(pivot);
  scene.joints.push_back(Revolute{.a = 2, .b = 0, .anchor = {-length / 2, 0}});
  return scene;
}

// J = (1+e) v/(1/m1 + d^2/Ip) turns the rod about its hinge; the hinge's own impulse is solved for with it. Iterations
// of one after the other leave the share Kjc^2/(Kjj Kcc) of the error each, where K are the entries of the inverse mass
// matrix of both. Once the rod turns with W:
//   first order   it moves along the tangent, and the hinge removes what is no longer tangential: (W h)^2/2 of the
//                 centre's share of the speed in each step;
//   second order  a step turns by at most atan(W h): (W h)^2/3 of W;
//   slop          the hinge may be off by it, slop/d in angle and, as an arm, 2 slop/d in J.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene built = scene(p);
  const Mass rod = mass_of(built.bodies[0]);
  const Mass striker = mass_of(built.bodies[1]);
  const double v = p.at("speed");
  const double e = p.at("restitution");
  const double d = p.at("distance");
  const double to_center = length / 2;
  const double about_hinge = rod.inertia + rod.mass * to_center * to_center;
  const double impulse = (1 + e) * v / (1 / striker.mass + d * d / about_hinge);
  const double spin = d * impulse / about_hinge;
  const double slower = impulse / striker.mass;
  const double beside = d - to_center;
  const double cross = 1 / rod.mass - to_center * beside / rod.inertia;
  const double rate = cross * cross /
                      ((1 / rod.mass + to_center * to_center / rod.inertia) *
                       (1 / rod.mass + 1 / striker.mass + beside * beside / rod.inertia));
  const double share = rod.mass * to_center * to_center / about_hinge;
  const struck_rod::Allowed allowed{v, 2 * (length + v + spin)};
  const auto jump = [=](const Stepping& s) {  // relative error of the impulse
    return (s.iterations > 0 ? std::pow(rate, s.iterations) : 0) + 2 * s.joint_slop / d;
  };
  const auto slowed = [=](const Stepping& s) {  // of the spin, in the whole run
    const double k = spin * s.h;
    return k * k / 3 + (first_order(s) ? share * k * k / 2 * after / s.h : 0);
  };
  const auto about = [=](const Stepping& s) { return spin * (jump(s) + slowed(s)) + allowed.exact(s); };
  const auto turn = [=](const Stepping& s) {
    return spin * found_off(s, v) + (allowed.overlap(s) + s.joint_slop) / d + about(s) * after + allowed.exact(s);
  };
  const auto leaves = [=](const Stepping& s) { return slower * jump(s) + allowed.exact(s); };
  const auto on_circle = [=](const Stepping& s) {
    const double k = spin * s.h;
    return to_center * (turn(s) + k * k / 2) + s.joint_slop;
  };
  return {{.body = "rod",
           .quantity = Quantity::angular_velocity,
           .expected = spin,
           .allowed = about,
           .source = "d J/Ip, J = (1+e) v/(1/m1 + d^2/Ip); iterations, slop, what a hinge loses as the rod turns"},
          {.body = "disc",
           .quantity = Quantity::vy,
           .expected = v - slower,
           .allowed = leaves,
           .source = "v - J/m; iterations, slop"},
          {.body = "rod",
           .quantity = Quantity::angle,
           .expected = spin * after,
           .allowed = turn,
           .source = "the jump of the spin times the lag, the overlap, slop"},
          {.body = "rod",
           .quantity = Quantity::x,
           .expected = to_center * (std::cos(spin * after) - 1),
           .allowed = on_circle,
           .source = "on its circle about the hinge; the angle's error, a step along the tangent, slop"},
          {.body = "disc",
           .quantity = Quantity::y,
           .expected = built.bodies[1].position.y + v * longest - slower * after,
           .allowed = [=](const Stepping& s) { return allowed.place(s, slower) + leaves(s) * after; },
           .source = "the velocity jump times the lag, and the overlap"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "hinged-hit",
     .question = "Does a hinged rod that is struck turn as its hinge and the blow together say?",
     .parameters =
         {{.name = "distance",
           .value = 1.6,
           .min = 0.5,
           .max = 1.9,
           .unit = "m",
           .about = "of the disc from the hinge; at 1.34 m the hinge feels nothing"},
          {.name = "speed", .value = 3, .min = 1.5, .max = 6, .unit = "m/s", .about = "of the disc"},
          {.name = "ratio", .value = 1, .min = 0.1, .max = 10, .about = "mass of the disc divided by that of the rod"},
          {.name = "restitution", .value = 0.5, .min = 0.2, .max = 1, .about = "of disc and rod"}},
     .variants = {{"e=0.5", {}}, {"hinge unmoved", {{"distance", sweet_spot}, {"restitution", 1}, {"ratio", 0.3}}}},
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::hinged_hit
