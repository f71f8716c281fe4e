#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/joints/linked.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::rope_bridge {
namespace {

constexpr double duration = 3;  // s
constexpr double length = 0.5;  // m, of a plank
constexpr double thick = 0.1;   // m

int half(const Parameters& p) { return static_cast<int>(p.at("half")); }

// The chain in equilibrium, from its middle to the right bank: the horizontal pull H is the same everywhere, the
// vertical one at the middle of plank j is half the load and j - 1/2 planks, and there the plank lies along the pull.
// In weights of a plank. H follows from the span, which grows with it: by bisection, to the last bit.
std::vector<Vec> catenary(const Parameters& p) {
  const auto from_middle = [&](double pull) {
    std::vector<Vec> points{{0, 0}};
    for (int j = 1; j <= half(p); ++j) {
      const double down = p.at("ratio") / 2 + j - 0.5;
      const double hypotenuse = std::hypot(pull, down);
      points.push_back({points.back().x + length * pull / hypotenuse, points.back().y + length * down / hypotenuse});
    }
    return points;
  };
  const double span = p.at("tight") * half(p) * length;
  double low = 0;
  double high = 1e9;
  for (double middle = high / 2; low < middle && middle < high; middle = (low + high) / 2) {
    (from_middle(middle).back().x < span ? low : high) = middle;
  }
  return from_middle(low);
}

// Hinged to a bank at either end; the load hangs from the middle hinge by its own middle.
Scene scene(const Parameters& p) {
  const auto right = catenary(p);
  std::vector<Vec> points;
  for (auto point = right.rbegin(); point != right.rend(); ++point) points.push_back({-point->x, point->y});
  points.insert(points.end(), right.begin() + 1, right.end());

  Scene scene{.name = "rope-bridge", .about = "A bridge of planks with a load in its middle.", .duration = duration};
  add_links(scene, points, thick);
  const std::size_t last = scene.bodies.size() - 1;
  scene.bodies.push_back({.name = "far bank", .type = BodyType::fixed, .position = points.back(), .layers = 0});
  scene.joints.push_back(Revolute{.a = last, .b = last + 1, .anchor = points.back()});
  Body load = disc("load", {0, 0}, 0.4, {});
  load.layers = 0;
  load.shapes[0].surface.density = p.at("ratio") * mass_of(scene.bodies[last]).mass / mass_of(load).mass;
  scene.bodies.push_back(load);
  scene.joints.push_back(Revolute{.a = last / 2, .b = last + 2, .anchor = {0, 0}});
  return scene;
}

// It hangs as it is. A chain longer by a gap a hinge lets the middle down by that over the sine of the least slope, to
// which the tilts of all planks add up; it stays in the middle, as the scene is its own mirror image.
std::vector<Expectation> expectations(const Parameters& p) {
  const auto chain = catenary(p);
  const double hinges = half(p) + 1;
  const double least = chain[1].y / length;
  const double reach = length * half(p) + 1;
  return {{.body = "load",
           .quantity = Quantity::y,
           .expected = 0,
           .allowed = [=](const Stepping& s) { return hinges * s.gap / least + round_off(s, duration, reach) / least; },
           .source = "equilibrium: H and the weights give each slope; a gap a hinge"},
          {.body = "load",
           .quantity = Quantity::x,
           .expected = 0,
           .allowed = [=](const Stepping& s) { return hinges * s.gap + round_off(s, duration, reach) / least; },
           .source = "symmetry"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "rope-bridge",
     .question = "Does a bridge of planks carry a heavy load where statics says it hangs?",
     .parameters =
         {{.name = "half",
           .value = 6,
           .min = 1,
           .max = 100,
           .about = "planks from the middle to a bank",
           .whole = true},
          {.name = "ratio", .value = 50, .min = 1, .max = 10000, .about = "mass of the load to that of a plank"},
          {.name = "tight", .value = 0.9, .min = 0.3, .max = 0.99, .about = "span to length"}},
     .variants = {{"light", {{"ratio", 1}}}, {"heavy", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::rope_bridge
