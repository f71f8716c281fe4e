#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::each_alone {
namespace {

constexpr double duration = 1;  // s
constexpr double gravity = 10;  // m/s^2

/// `body` is at `end` then but for what it falls, and at `angle`: off by the drift g t h and round-off. `reach`: m,
/// that any body is from the origin at most.
void expect_alone(const Body& body, const Vec& end, double angle, double reach, std::vector<Expectation>& all) {
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, reach); };
  all.push_back(
      {.body = body.name, .quantity = Quantity::x, .expected = end.x, .allowed = exact, .source = "v t, as if alone"});
  all.push_back({.body = body.name,
                 .quantity = Quantity::y,
                 .expected = end.y - gravity * duration * duration / 2,
                 .allowed = [=](const Stepping& s) { return drifted(s, gravity, duration) + exact(s); },
                 .source = "v t + g t^2/2, as if alone; drift g t h"});
  all.push_back({.body = body.name,
                 .quantity = Quantity::angle,
                 .expected = angle,
                 .allowed = exact,
                 .source = "w t, as if alone"});
}

}  // namespace
}  // namespace plumb::scenarios::each_alone

namespace plumb::scenarios::free_bodies {
namespace {

using each_alone::duration;
using each_alone::gravity;

constexpr double pitch = 1;     // m, from body to body
constexpr double spread = 0.5;  // 1/s
constexpr double spin = 3;      // rad/s

int side(const Parameters& p) { return static_cast<int>(p.at("side")); }

// Every body flies away from the middle, faster the farther out it starts, so no two ever get closer.
Scene scene(const Parameters& p) {
  Scene scene{.name = "free-bodies",
              .about = "A field of boxes and discs flies apart while falling; no two ever collide.",
              .gravity = {0, -gravity},
              .duration = duration};
  const double middle = (side(p) - 1) / 2.0;
  for (int i = 0; i < side(p) * side(p); ++i) {
    const int row = i / side(p);
    const int column = i % side(p);
    const Vec at{(column - middle) * pitch, (row - middle) * pitch};
    const std::string name = "body " + std::to_string(i + 1);
    Body one = i % 2 == 0 ? box(name, at, {0.5, 0.5}, surface(0.5, 0.5)) : disc(name, at, 0.25, surface(0.5, 0.5));
    one.velocity = {spread * at.x, spread * at.y};
    one.angular_velocity = spin;
    scene.bodies.push_back(one);
  }
  return scene;
}

// Each moves as if alone: r = r0 (1 + c t) + g t^2/2, angle = w t.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene field = scene(p);
  const double grown = 1 + spread * duration;
  const double reach = pitch * side(p) * grown + gravity * duration * duration;
  std::vector<Expectation> all;
  for (const Body& body : {field.bodies.front(), field.bodies[field.bodies.size() / 2], field.bodies.back()}) {
    each_alone::expect_alone(body, grown * body.position, spin * duration, reach, all);
  }
  return all;
}

const Catalog<Scenario>::Entry entry{{.name = "free-bodies",
                                      .question = "Do many bodies that never collide each fly as if alone?",
                                      .parameters = {{.name = "side",
                                                      .value = 12,
                                                      .min = 1,
                                                      .max = 200,
                                                      .about = "bodies along each side of the square field",
                                                      .whole = true}},
                                      .variants = {{"144", {}}},
                                      .scene = scene,
                                      .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::free_bodies

namespace plumb::scenarios::thrown_wall {
namespace {

using each_alone::duration;
using each_alone::gravity;

constexpr double size = .5;    // m, of each box
constexpr double gap = .022;   // m, wider than the skins of engines, and near enough for a contact
constexpr Vec velocity{3, 4};  // m/s

int side(const Parameters& p) { return static_cast<int>(p.at("side")); }

// All are thrown alike.
Scene scene(const Parameters& p) {
  Scene scene{.name = "thrown-wall",
              .about = "Boxes a finger's breadth from each other are thrown together, and fall.",
              .gravity = {0, -gravity},
              .duration = duration};
  for (int i = 0; i < side(p) * side(p); ++i) {
    const int row = i / side(p);
    const int column = i % side(p);
    const Vec at{(size + gap) * column, (size + gap) * row};
    scene.bodies.push_back(box("box " + std::to_string(i + 1), at, {size, size}, surface(0.5, 0.5)));
    scene.bodies.back().velocity = velocity;
  }
  return scene;
}

// None presses another.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene wall = scene(p);
  const double reach = (size + gap) * side(p) + (length(velocity) + gravity * duration) * duration;
  std::vector<Expectation> all;
  for (const Body& body : {wall.bodies.front(), wall.bodies[wall.bodies.size() / 2], wall.bodies.back()}) {
    each_alone::expect_alone(body, body.position + duration * velocity, 0, reach, all);
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "thrown-wall",
     .question = "Do bodies beside each other, none of which presses another, fly as if alone?",
     .parameters = {{.name = "side",
                     .value = 9,
                     .min = 1,
                     .max = 60,
                     .about = "boxes along each side of the wall",
                     .whole = true}},
     .variants = {{"81 boxes", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::thrown_wall

namespace plumb::scenarios::layers {
namespace {

constexpr double duration = 2;  // s, long enough for the two to pass through each other
constexpr double gravity = 10;  // m/s^2
constexpr double start = 4;     // m from the middle

Scene scene(const Parameters& p) {
  const double v = p.at("speed");
  Scene scene{.name = "layers",
              .about = "Two boxes on separate layers fly through each other.",
              .gravity = {0, -gravity},
              .duration = duration};
  for (const double side : {-1.0, 1.0}) {
    Body one = box(side < 0 ? "left" : "right", {side * start, 0}, {1, 1}, surface(0.5, 0.5));
    one.velocity = {-side * v, 0};
    one.angular_velocity = side;
    one.layers = side < 0 ? 1 : 2;
    scene.bodies.push_back(one);
  }
  return scene;
}

// Each falls freely: off by the drift g t h and round-off.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double fall = gravity * duration;
  const double reach = start + (v + fall) * duration;
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, reach); };
  const auto height = [=](const Stepping& s) { return drifted(s, gravity, duration) + exact(s); };
  std::vector<Expectation> all;
  for (const char* body : {"left", "right"}) {
    all.push_back({.body = body, .quantity = Quantity::x, .allowed = exact, .source = "v t, as if alone"});
    all.push_back(
        {.body = body, .quantity = Quantity::y, .allowed = height, .source = "g t^2/2, as if alone; drift g t h"});
    all.push_back({.body = body, .quantity = Quantity::angle, .allowed = exact, .source = "w t, as if alone"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "layers",
     .question = "Do bodies that share no layer pass through each other without contact?",
     .parameters = {{.name = "speed", .value = 4, .min = 0.1, .max = 100, .unit = "m/s", .about = "of each box"}},
     .variants = {{"cross", {}}},
     .closed_form = "ballistic",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::layers
