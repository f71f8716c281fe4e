#include <cmath>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::dumbbells {
namespace {

constexpr double gravity = 10;    // m/s^2
constexpr double duration = 1.5;  // s
constexpr double half = 0.8;      // m, from the centre to either disc's
constexpr double radius = 0.3;    // m
constexpr double at_start = 0.4;  // rad, of the line between the discs
constexpr Vec thrown{2, 8};       // m/s

constexpr const char* ways[] = {"rod", "weld", "one body"};

// Three pairs of discs, thrown with the same velocity and spin: held by a rigid rod, by a weld, and both in one body.
Scene scene(const Parameters& p) {
  const double turn = p.at("turn");
  const Vec arm{half * std::cos(at_start), half * std::sin(at_start)};
  Scene scene{.name = "dumbbells",
              .about = "Three dumbbells are thrown: of two discs on a rod, of two welded discs, and of one body.",
              .gravity = {0, -gravity},
              .duration = duration};
  for (const int way : {0, 1, 2}) {
    const Vec center{0, 4.0 * way};
    if (way == 2) {
      Body one{.name = ways[way], .position = center, .angle = at_start, .velocity = thrown, .angular_velocity = turn};
      one.shapes = {{.geometry = Circle{radius, {half, 0}}, .surface = {}},
                    {.geometry = Circle{radius, {-half, 0}}, .surface = {}}};
      one.layers = 0;
      scene.bodies.push_back(one);
      continue;
    }
    for (const double side : {1.0, -1.0}) {
      Body end = disc(std::string(side > 0 ? "first on " : "second on ") + ways[way],
                      {center.x + side * arm.x, center.y + side * arm.y}, radius, {});
      end.angle = at_start;
      end.velocity = {thrown.x - side * turn * arm.y, thrown.y + side * turn * arm.x};
      end.angular_velocity = turn;
      end.layers = 0;
      scene.bodies.push_back(end);
    }
    const std::size_t first = scene.bodies.size() - 2;
    const Vec a = scene.bodies[first].position;
    const Vec b = scene.bodies[first + 1].position;
    if (way == 0) {
      scene.joints.push_back(Distance{.a = first, .b = first + 1, .anchor_a = a, .anchor_b = b, .length = 2 * half});
    } else {
      scene.joints.push_back(Weld{.a = first, .b = first + 1, .anchor = center});
    }
  }
  return scene;
}

// Each turns evenly about a centre that falls freely; gravity has no moment about it.
//   first order   a disc moves along its tangent and the joint removes what is no longer tangential: (W h)^2/2 of the
//                 circling's speed in each step, all of it on a rod, its share of the inertia in a weld;
//   second order  (W h)^2/3 of W;
//   slop          each disc may be off by it, and turn by slop/(2 half) about the other.
std::vector<Expectation> expectations(const Parameters& p) {
  const double turn = p.at("turn");
  const double swept = turn * duration;
  const Mass end = mass_of(scene(p).bodies[0]);
  const double circling = end.mass * half * half;
  const double reach = half + (10 + gravity * duration) * duration + swept;
  const auto round = [=](const Stepping& s) { return round_off(s, duration, reach); };
  const auto angle = [=](const Stepping& s, int way) {
    if (way == 2) return round(s);
    const double k = turn * s.h;
    const double share = way == 0 ? 1 : circling / (circling + end.inertia);
    const double lost = first_order(s) ? share * k * k / 2 * duration / s.h : 0;
    return swept * (lost + k * k / 3) + s.joint_slop / (2 * half) + round(s);
  };
  const Vec arm{half * std::cos(at_start + swept), half * std::sin(at_start + swept)};
  std::vector<Expectation> all;
  for (const int way : {0, 1, 2}) {
    const std::string body = way == 2 ? ways[way] : std::string("first on ") + ways[way];
    const Vec off = way == 2 ? Vec{} : arm;
    const auto place = [=](const Stepping& s) {
      return drifted(s, gravity, duration) + (way == 2 ? 0 : half * angle(s, way) + s.joint_slop) + round(s);
    };
    const auto add = [&](Quantity quantity, double expected, const auto& allowed, const char* source) {
      all.push_back({.body = body, .quantity = quantity, .expected = expected, .allowed = allowed, .source = source});
    };
    add(Quantity::x, thrown.x * duration + off.x, place, "circles the centre, which is thrown; slop");
    add(Quantity::y, 4.0 * way + thrown.y * duration - gravity * duration * duration / 2 + off.y, place,
        "circles the centre, which falls freely; drift, slop");
    // The line between the discs turns with W, and so does each disc; nothing but a weld or the body holds it to that.
    add(
        Quantity::angle, at_start + swept, [=](const Stepping& s) { return way == 0 ? round(s) : angle(s, way); },
        "turns evenly; on a rod of its own accord, as the rod pulls at its centre");
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "dumbbells",
     .question = "Do two discs on a rod, two welded discs and one body of both fly and turn alike?",
     .parameters = {{.name = "turn", .value = 3, .min = 0.1, .max = 10, .unit = "rad/s", .about = "angular velocity"}},
     .variants = {{"thrown", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::dumbbells
