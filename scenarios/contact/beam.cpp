#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::beam {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 2;  // s
constexpr double radius = 0.5;  // m, of a support
constexpr double friction = 0.5;
const Vec size{8, 0.5};  // m

Scene scene(const Parameters& p) {
  const Surface rough = surface(friction, 0);
  Scene scene{
      .name = "beam", .about = "A beam lies on two round supports.", .gravity = {0, -gravity}, .duration = duration};
  scene.bodies.push_back(disc("left", {-p.at("a"), radius}, radius, rough));
  scene.bodies.push_back(disc("right", {p.at("b"), radius}, radius, rough));
  for (Body& support : scene.bodies) support.type = BodyType::fixed;
  scene.bodies.push_back(box("beam", {0, 2 * radius + size.y / 2}, size, rough));
  return scene;
}

// Nothing moves, so the supports' impulses and their moments about either support balance the weight's, m g t. What may
// be missing is a lag at the start, during which no support may push, and the speed of a last step. The position of the
// bearing is known to the slop by which one support may be deeper, divided by the distance of the supports.
std::vector<Expectation> expectations(const Parameters& p) {
  const double a = p.at("a");
  const double b = p.at("b");
  const double weight = mass_of(scene(p).bodies[2]).mass * gravity;
  const auto missing = [=](const Stepping& s) {
    return weight * ((lag(s) + s.h) / duration + s.slop / (a + b)) + round_off(s, duration, weight);
  };
  const auto tilt = [=](const Stepping& s) { return s.slop / (a + b) + round_off(s, duration, size.x / (a + b)); };
  const auto height = [=](const Stepping& s) {
    return s.contact_gap() + gravity * lag(s) * (lag(s) + s.h) + round_off(s, duration, size.x);
  };
  return {{.body = "beam",
           .other = "left",
           .quantity = Quantity::load,
           .over = duration,
           .expected = weight * b / (a + b),
           .allowed = missing,
           .source = "m g b/(a + b), on average; a lag at the start and the last step"},
          {.body = "beam",
           .other = "right",
           .quantity = Quantity::load,
           .over = duration,
           .expected = weight * a / (a + b),
           .allowed = missing,
           .source = "m g a/(a + b), on average; a lag at the start and the last step"},
          {.body = "beam",
           .quantity = Quantity::y,
           .allowed = height,
           .source = "equilibrium: does not move, within the gap and the fall during a lag"},
          {.body = "beam",
           .quantity = Quantity::angle,
           .allowed = tilt,
           .source = "equilibrium: one support may be deeper by the slop"}};
}

const Catalog<Scenario>::Entry entry{{.name = "beam",
                                      .question = "Do two supports share the weight of a beam by the law of the lever?",
                                      .parameters = {{.name = "a",
                                                      .value = 1,
                                                      .min = 0.6,
                                                      .max = 3.5,
                                                      .unit = "m",
                                                      .about = "from the left support to the centre"},
                                                     {.name = "b",
                                                      .value = 3,
                                                      .min = 0.6,
                                                      .max = 3.5,
                                                      .unit = "m",
                                                      .about = "from the centre to the right support"}},
                                      .variants = {{"1:3", {}}, {"even", {{"a", 3}}}},
                                      .closed_form = "beam",
                                      .scene = scene,
                                      .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::beam
