#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::each_alone {
namespace {

constexpr double duration = 1;  // s
constexpr double gravity = 10;  // m/s^2

/// The flight of bodies that move as if alone, slowed by `damping`, 1/s. `reach`: m, that any is from the origin at
/// most.
struct Flight {
  double reach = 0;
  double damping = 0;

  /// s and s^2, the ways of a velocity of 1 m/s and of an acceleration of 1 m/s^2.
  double by_velocity() const { return damping > 0 ? -std::expm1(-damping * duration) / damping : duration; }
  double by_force() const { return damping > 0 ? (duration - by_velocity()) / damping : duration * duration / 2; }
  /// m, by which the damping of a body that goes at most at this speed, m/s, and falls so fast, m/s^2, may be off.
  double damping_off(const Stepping& s, double speed, double falls) const {
    return damping > 0 ? damped_way_error(s, damping, speed, duration, falls) : 0;
  }
};

/// The body goes on with its velocities: off by the drift g t h, by damping and round-off.
void expect_alone(const Body& body, const Flight& flight, std::vector<Expectation>& all) {
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, flight.reach); };
  const Vec v = body.velocity;
  const double sinks = v.y * std::exp(-flight.damping * duration) - gravity * flight.by_velocity();  // m/s, at the end
  const Vec end = body.position + flight.by_velocity() * v;
  all.push_back({.body = body.name,
                 .quantity = Quantity::x,
                 .expected = end.x,
                 .allowed = [=](const Stepping& s) { return exact(s) + flight.damping_off(s, std::abs(v.x), 0); },
                 .source = flight.damping > 0 ? "v (1 - e^(-ct))/c, as if alone" : "v t, as if alone"});
  all.push_back({.body = body.name,
                 .quantity = Quantity::y,
                 .expected = end.y - gravity * flight.by_force(),
                 .allowed =
                     [=](const Stepping& s) {
                       const double fastest = std::max(std::abs(v.y), std::abs(sinks));
                       return drifted(s, gravity, duration) + exact(s) + flight.damping_off(s, fastest, gravity);
                     },
                 .source = flight.damping > 0
                               ? "v (1 - e^(-ct))/c + g (t - (1 - e^(-ct))/c)/c, as if alone; drift g t h"
                               : "v t + g t^2/2, as if alone; drift g t h"});
  all.push_back({.body = body.name,
                 .quantity = Quantity::angle,
                 .expected = body.angular_velocity * duration,
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
    each_alone::expect_alone(body, {.reach = reach}, all);
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

// All are thrown alike, and slowed alike.
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
    scene.bodies.back().linear_damping = p.at("damping");
  }
  return scene;
}

// None presses another.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene wall = scene(p);
  const double reach = (size + gap) * side(p) + (length(velocity) + gravity * duration) * duration;
  std::vector<Expectation> all;
  for (const Body& body : {wall.bodies.front(), wall.bodies[wall.bodies.size() / 2], wall.bodies.back()}) {
    each_alone::expect_alone(body, {.reach = reach, .damping = p.at("damping")}, all);
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
                     .whole = true},
                    {.name = "damping", .value = 0, .min = 0, .max = 5, .unit = "1/s", .about = "of their velocities"}},
     .variants = {{"81 boxes", {}}, {"damped", {{"damping", 1}}}},
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
