#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "scenarios/joints/swing.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::kater {
namespace {

constexpr double gravity = 10;     // m/s^2
constexpr double period = 2;       // s, whatever the amplitude
constexpr double thickness = 0.1;  // m
constexpr double apart = 4;        // m, between the two hinges

double amplitude(const Parameters& p) { return p.at("angle") * degree; }

struct Hung {
  std::string name;
  double distance;  // m, from the hinge to the centre
  Vec hinge;
};

// The two distances that have the period's length L = d + k^2/d, k the radius of gyration: d1 + d2 = L, d1 d2 = k^2
// (Huygens 1673, Kater 1818).
std::vector<Hung> hung(const Parameters& p) {
  const double length = simple_pendulum(period, amplitude(p), gravity);
  const double k2 = (p.at("rod") * p.at("rod") + thickness * thickness) / 12;
  const double half = std::sqrt(length * length / 4 - k2);
  return {{"near", length / 2 - half, {0, 0}}, {"far", length / 2 + half, {apart, 0}}};
}

Scene scene(const Parameters& p) {
  const double a = amplitude(p);
  Scene scene{.name = "kater",
              .about = "Two equal rods hang from conjugate points.",
              .gravity = {0, -gravity},
              .duration = period};
  scene.bodies.push_back({.name = "ceiling", .type = BodyType::fixed, .layers = 0});
  for (const Hung& one : hung(p)) {
    const Vec center{one.hinge.x + one.distance * std::sin(a), one.hinge.y - one.distance * std::cos(a)};
    Body rod = box(one.name, center, {thickness, p.at("rod")}, {});
    rod.angle = a;
    rod.layers = 0;
    scene.joints.push_back(Revolute{.a = 0, .b = scene.bodies.size(), .anchor = one.hinge});
    scene.bodies.push_back(rod);
  }
  return scene;
}

// Both swing alike, as HingedRod says.
std::vector<Expectation> expectations(const Parameters& p) {
  const double a = amplitude(p);
  const Mass mass = mass_of(scene(p).bodies[1]);
  std::vector<Expectation> all;
  for (const Hung& one : hung(p)) {
    const double inertia = mass.inertia + mass.mass * one.distance * one.distance;
    const HingedRod rod{a, one.distance, mass.mass * gravity, inertia,
                        mass.mass * one.distance * one.distance / inertia};
    for (const int quarter : {1, 2}) {
      const double t = quarter * period / 4;
      const auto turn = [=](const Stepping& s) { return rod.turn(s, t); };
      const auto place = [=, d = one.distance](const Stepping& s) { return d * rod.turn(s, t) + s.joint_slop; };
      const std::string where =
          quarter == 1 ? "below its hinge after a quarter" : "as far on the other side after half";
      all.push_back({.body = one.name,
                     .quantity = Quantity::angle,
                     .time = t,
                     .expected = quarter == 1 ? 0 : -a,
                     .allowed = turn,
                     .source = where + " of the period of d + k^2/d; the method's phase error"});
      all.push_back({.body = one.name,
                     .quantity = Quantity::x,
                     .time = t,
                     .expected = one.hinge.x - (quarter == 1 ? 0 : one.distance * std::sin(a)),
                     .allowed = place,
                     .source = where + " of the period of d + k^2/d; d times the angle's error"});
    }
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "kater",
     .question = "Does a rod swing alike about two points at distances d and k^2/d from its centre?",
     .parameters = {{.name = "angle", .value = 30, .min = 5, .max = 60, .unit = "deg", .about = "of release"},
                    {.name = "rod", .value = 1.4, .min = 0.5, .max = 1.45, .unit = "m", .about = "length of each rod"}},
     .variants = {{"30deg", {}}, {"60deg", {{"angle", 60}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::kater
