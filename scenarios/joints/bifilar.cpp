#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scenarios/joints/swing.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::bifilar {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double period = 2;    // s, whatever the amplitude
constexpr double apart = 1.2;   // m, between the two rods
constexpr Vec size{1.6, 0.2};   // m, of the bar
constexpr double aside = 0.3;   // m, of the bar's centre from the middle between the rods

double amplitude(const Parameters& p) { return p.at("angle") * degree; }
double length(const Parameters& p) { return simple_pendulum(period, amplitude(p), gravity); }

// m, of the bar's centre below the ceiling where it hangs straight down is the length; it swings by `angle`.
Vec centre(double length, double angle) { return {aside + length * std::sin(angle), -length * std::cos(angle)}; }

Scene scene(const Parameters& p) {
  const double a = amplitude(p);
  const double l = length(p);
  Scene scene{.name = "bifilar",
              .about = "A bar swings from two parallel rods of equal length.",
              .gravity = {0, -gravity},
              .duration = period};
  Body bar = box("bar", centre(l, a), size, {});
  bar.layers = 0;
  scene.bodies = {{.name = "ceiling", .type = BodyType::fixed, .layers = 0}, bar};
  for (const double side : {-1.0, 1.0}) {
    const Vec hook{side * apart / 2, 0};
    scene.joints.push_back(Distance{
        .a = 0, .b = 1, .anchor_a = hook, .anchor_b = {hook.x + l * std::sin(a), -l * std::cos(a)}, .length = l});
  }
  return scene;
}

// Both rods stay parallel, so that the bar moves along a circle and never turns: it swings like a point on one rod,
// whatever its moment of inertia and wherever its centre. As HingedRod with all of its energy in the centre. The rods
// may differ by the slop each, which turns the bar by two slops over their distance.
std::vector<Expectation> expectations(const Parameters& p) {
  const double a = amplitude(p);
  const double l = length(p);
  const Mass mass = mass_of(scene(p).bodies[1]);
  const HingedRod rod{a, l, mass.mass * gravity, mass.mass * l * l, 1};
  std::vector<Expectation> all;
  for (const int quarter : {1, 2, 4}) {
    const double t = quarter * period / 4;
    const Vec at = centre(l, quarter == 1 ? 0 : quarter == 2 ? -a : a);
    const std::string source = "on the circle of its rods, with their period; the method's phase error";
    const auto tilt = [=](const Stepping& s) { return 2 * s.joint_slop / apart + round_off(s, t, 2 * l / apart); };
    const auto place = [=](const Stepping& s) { return l * rod.turn(s, t) + s.joint_slop + aside * tilt(s); };
    all.push_back(
        {.body = "bar", .quantity = Quantity::x, .time = t, .expected = at.x, .allowed = place, .source = source});
    all.push_back(
        {.body = "bar", .quantity = Quantity::y, .time = t, .expected = at.y, .allowed = place, .source = source});
    all.push_back({.body = "bar",
                   .quantity = Quantity::angle,
                   .time = t,
                   .expected = 0,
                   .allowed = tilt,
                   .source = "the rods stay parallel; a slop of either"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "bifilar",
     .question = "Does a bar on two equal rods swing like a point on one of them, without turning?",
     .parameters = {{.name = "angle", .value = 30, .min = 5, .max = 60, .unit = "deg", .about = "of release"}},
     .variants = {{"30deg", {}}, {"60deg", {{"angle", 60}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::bifilar
