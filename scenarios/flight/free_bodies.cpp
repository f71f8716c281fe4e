#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::free_bodies {
namespace {

constexpr double duration = 1;  // s
constexpr double gravity = 10;  // m/s^2
constexpr double pitch = 1;     // m, from body to body
constexpr double spread = 0.5;  // 1/s
constexpr double spin = 3;      // rad/s

int side(const Parameters& p) { return static_cast<int>(p.at("side")); }

// Each flies away from the middle, the faster the farther: no two ever come nearer.
Scene scene(const Parameters& p) {
  Scene scene{.name = "free-bodies",
              .about = "A field of boxes and discs flies apart as it falls; none meets another.",
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

// As if alone: r = r0 (1 + c t) + g t^2/2, angle = w t.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene field = scene(p);
  const double grown = 1 + spread * duration;
  const double reach = pitch * side(p) * grown + gravity * duration * duration;
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, reach); };
  std::vector<Expectation> all;
  for (const Body& body : {field.bodies.front(), field.bodies[field.bodies.size() / 2], field.bodies.back()}) {
    all.push_back({.body = body.name,
                   .quantity = Quantity::x,
                   .expected = body.position.x * grown,
                   .allowed = exact,
                   .source = "v t, as if alone"});
    all.push_back({.body = body.name,
                   .quantity = Quantity::y,
                   .expected = body.position.y * grown - gravity * duration * duration / 2,
                   .allowed = [=](const Stepping& s) { return drifted(s, gravity, duration) + exact(s); },
                   .source = "v t + g t^2/2, as if alone; drift g t h"});
    all.push_back({.body = body.name,
                   .quantity = Quantity::angle,
                   .expected = spin * duration,
                   .allowed = exact,
                   .source = "w t, as if alone"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "free-bodies",
     .question = "Do many bodies that never meet fly as if alone?",
     .parameters =
         {{.name = "side", .value = 12, .min = 1, .max = 200, .about = "its square is their number", .whole = true}},
     .variants = {{"144", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::free_bodies
