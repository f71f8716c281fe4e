#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/joints/linked.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::hanging_chain {
namespace {

constexpr double duration = 3;  // s
constexpr double length = 0.5;  // m, of a link
constexpr double thick = 0.1;   // m

// By `angle` from the vertical, straight, at rest; the load hangs on the last link by its middle.
Scene scene(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  std::vector<Vec> points;
  for (int i = 0; i <= static_cast<int>(p.at("links")); ++i) {
    points.push_back({i * length * std::sin(angle), -i * length * std::cos(angle)});
  }
  Scene scene{.name = "hanging-chain", .about = "A chain of light links with a heavy end.", .duration = duration};
  add_links(scene, points, thick);
  const std::size_t last = scene.bodies.size() - 1;
  Body load = disc("load", points.back(), 0.4, {});
  load.layers = 0;
  load.shapes[0].surface.density = p.at("ratio") * mass_of(scene.bodies[last]).mass / mass_of(load).mass;
  scene.bodies.push_back(load);
  scene.joints.push_back(Revolute{.a = last, .b = last + 1, .anchor = points.back()});
  return scene;
}

// A chain that hangs straight down stays so, and each hinge may give by a gap. Let go from the side it has no closed
// form.
std::vector<Expectation> expectations(const Parameters& p) {
  if (p.at("angle") != 0) return {};
  const double hinges = p.at("links") + 1;
  const double reach = p.at("links") * length;
  const auto place = [=](const Stepping& s) { return hinges * s.gap + round_off(s, duration, reach + 1); };
  return {{.body = "load",
           .quantity = Quantity::y,
           .expected = -reach,
           .allowed = place,
           .source = "equilibrium: links keep their length, but for a gap a hinge"},
          {.body = "load",
           .quantity = Quantity::x,
           .expected = 0,
           .allowed = place,
           .source = "equilibrium: hangs straight down"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "hanging-chain",
     .question = "Does a chain of light links carry a heavy end?",
     .parameters =
         {{.name = "links", .value = 10, .min = 1, .max = 200, .about = "of the chain", .whole = true},
          {.name = "ratio", .value = 100, .min = 0.01, .max = 10000, .about = "mass of the load to that of a link"},
          {.name = "angle",
           .value = 0,
           .min = 0,
           .max = 90,
           .unit = "deg",
           .about = "from the vertical, at the start"}},
     .variants = {{"still", {}}, {"swing", {{"angle", 60}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::hanging_chain
