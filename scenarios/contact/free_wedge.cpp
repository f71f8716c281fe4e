#include <cmath>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::free_wedge {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 1;  // s
constexpr double height = 3.5;  // m, of the wedge
constexpr double start = 0.8;   // m along the slope, from its top to the box's centre
constexpr Vec size{0.8, 0.4};   // m, of the box

double slope_of(const Parameters& p) { return p.at("angle") * degree; }

// The slope falls to the right from the wedge's upper left corner; the body's frame is at its lower left one.
Scene scene(const Parameters& p) {
  const double angle = slope_of(p);
  const Vec down{std::cos(angle), -std::sin(angle)};
  const double base = height / std::tan(angle);
  Scene scene{.name = "free-wedge",
              .about = "A box slides down a wedge that is free to slide itself, without friction.",
              .gravity = {0, -gravity},
              .duration = duration};
  scene.bodies.push_back(level_ground(surface(0, 0)));
  const double area = base * height / 2;
  scene.bodies.push_back({.name = "wedge",
                          .shapes = {{.geometry = Polygon{{{0, 0}, {base, 0}, {0, height}}},
                                      .surface = surface(0, 0, p.at("ratio") * size.x * size.y / area)}}});
  Body slides = box("box", {start * down.x - size.y / 2 * down.y, height + start * down.y + size.y / 2 * down.x}, size,
                    surface(0, 0));
  slides.angle = -angle;
  scene.bodies.push_back(slides);
  return scene;
}

// Horizontal momentum is kept and the box stays on the slope (Landau & Lifshitz, Mechanics, 5): along the slope, and of
// the wedge to the left,
//   a = (M + m) g sin/(M + m sin^2),   A = m g sin cos/(M + m sin^2).
//   Contact     may be found a lag late: until then both fall freely, and the blow that ends the fall has just the
//               impulses that were missing.
//   Iterations  the pushes of slope and floor on the wedge oppose each other by cos a: each iteration leaves
//               cos^2 a m/(M + m) of an error.
//   Lean        of box or wedge by the gap at both ends turns a push by gap/length, which changes accelerations by that
//               of the push, at most (1 + m/M) g.
std::vector<Expectation> expectations(const Parameters& p) {
  const double angle = slope_of(p);
  const double c = std::cos(angle);
  const double sine = std::sin(angle);
  const double ratio = p.at("ratio");
  const double t = duration;
  const double along = (ratio + 1) * gravity * sine / (ratio + sine * sine);
  const double back = gravity * sine * c / (ratio + sine * sine);
  const Scene built = scene(p);
  const double most = std::max(along, gravity) + back;
  const double reach = 2 * height / std::tan(angle) + most * t;
  const double rate = c * c / (ratio + 1);
  const double push = (1 + 1 / ratio) * gravity;
  const auto speed = [=](const Stepping& s) {
    const double left = s.iterations > 0 ? std::pow(rate, s.iterations) : 0;
    return (push * 2 * s.contact_gap() / size.x + most * left) * t + round_off(s, t, reach);
  };
  const auto place = [=](const Stepping& s) {
    return speed(s) * t / 2 + drifted(s, most, t) + slid_late(s, most) + s.contact_gap() + round_off(s, t, reach);
  };
  const Mass wedge = mass_of(built.bodies[1]);
  const double x = built.bodies[2].position.x;
  const double y = built.bodies[2].position.y;
  return {{.body = "wedge",
           .quantity = Quantity::vx,
           .expected = -back * t,
           .allowed = speed,
           .source = "m g sin cos/(M + m sin^2) t; lean by the gap, iterations"},
          {.body = "box",
           .quantity = Quantity::vx,
           .expected = (along * c - back) * t,
           .allowed = speed,
           .source = "horizontal momentum is kept; lean by the gap, iterations"},
          {.body = "box",
           .quantity = Quantity::vy,
           .expected = -along * sine * t,
           .allowed = speed,
           .source = "(M + m) g sin^2/(M + m sin^2) t; lean by the gap, iterations"},
          {.body = "wedge",
           .quantity = Quantity::x,
           .expected = wedge.center.x - back * t * t / 2,
           .allowed = place,
           .source = "A t^2/2; contact a lag late, drift, gap"},
          {.body = "box",
           .quantity = Quantity::x,
           .expected = x + (along * c - back) * t * t / 2,
           .allowed = place,
           .source = "a t^2/2 along the slope, which moves back; contact a lag late, drift, gap"},
          {.body = "box",
           .quantity = Quantity::y,
           .expected = y - along * sine * t * t / 2,
           .allowed = place,
           .source = "a t^2/2 along the slope; contact a lag late, drift, gap"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "free-wedge",
     .question = "Does a box slide down a free wedge as fast as both masses say, and push it back?",
     .parameters =
         {{.name = "angle", .value = 30, .min = 20, .max = 40, .unit = "deg", .about = "of the slope"},
          {.name = "ratio", .value = 2, .min = 1, .max = 100, .about = "mass of the wedge divided by that of the box"}},
     .variants = {{"M=2m", {}}, {"M=m", {{"ratio", 1}, {"angle", 25}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::free_wedge
