#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/sag.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::chains {
namespace {

// Adds a fixed body "hook" at the first point and capsules "link 1", "link 2" ... from each point to the next, hinged
// at every point except the last. They collide with nothing. Thickness, m.
void add_links(Scene& scene, std::span<const Vec> points, double thickness) {
  scene.bodies.push_back({.name = "hook", .type = BodyType::fixed, .position = points[0], .layers = 0});
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec from = points[i - 1];
    const Vec to = points[i];
    const double straight = (std::hypot(to.x - from.x, to.y - from.y) - thickness) / 2;
    scene.bodies.push_back(
        {.name = "link " + std::to_string(i),
         .position = {(from.x + to.x) / 2, (from.y + to.y) / 2},
         .angle = std::atan2(to.y - from.y, to.x - from.x),
         .layers = 0,
         .shapes = {{.geometry = Capsule{{-straight, 0}, {straight, 0}, thickness / 2}, .surface = surface(0.5, 0)}}});
    const std::size_t link = scene.bodies.size() - 1;
    scene.joints.push_back(Revolute{.a = link - 1, .b = link, .anchor = from});
  }
}

}  // namespace
}  // namespace plumb::scenarios::chains

namespace plumb::scenarios::hanging_chain {
namespace {

constexpr double duration = 3;  // s
constexpr double length = 0.5;  // m, of a link
constexpr double thick = 0.1;   // m

// Straight, at `angle` from the vertical, at rest; the load hangs from the last link by its centre.
Scene scene(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  std::vector<Vec> points;
  for (int i = 0; i <= static_cast<int>(p.at("links")); ++i) {
    points.push_back({i * length * std::sin(angle), -i * length * std::cos(angle)});
  }
  Scene scene{.name = "hanging-chain",
              .about = "A chain of light links carries a heavy load at its end.",
              .duration = duration};
  chains::add_links(scene, points, thick);
  const std::size_t last = scene.bodies.size() - 1;
  Body load = disc("load", points.back(), 0.4, {});
  load.layers = 0;
  load.shapes[0].surface.density = p.at("ratio") * mass_of(scene.bodies[last]).mass / mass_of(load).mass;
  scene.bodies.push_back(load);
  scene.joints.push_back(Revolute{.a = last, .b = last + 1, .anchor = points.back()});
  return scene;
}

// A chain that hangs straight down does not move, but each hinge may be off by its slop, or give way by what hangs from
// it where it is a spring. Released from the side it has no closed form.
std::vector<Expectation> expectations(const Parameters& p) {
  if (p.at("angle") != 0) return {};
  const double hinges = p.at("links") + 1;
  const double reach = p.at("links") * length;
  const Scene chain = scene(p);
  const auto place = [=](const Stepping& s) {
    return hinges * s.joint_slop + sag(s, chain, chain.bodies.size() - 1) + round_off(s, duration, reach + 1);
  };
  return {{.body = "load",
           .quantity = Quantity::y,
           .expected = -reach,
           .allowed = place,
           .source = "equilibrium: links keep their length; one slop per hinge"},
          {.body = "load",
           .quantity = Quantity::x,
           .expected = 0,
           .allowed = place,
           .source = "equilibrium: hangs straight down"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "hanging-chain",
     .question = "Does a chain of light links carry a heavy load?",
     .parameters = {{.name = "links", .value = 10, .min = 1, .max = 200, .about = "in the chain", .whole = true},
                    {.name = "ratio",
                     .value = 100,
                     .min = 0.01,
                     .max = 10000,
                     .about = "mass of the load divided by that of a link"},
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

namespace plumb::scenarios::rope_bridge {
namespace {

constexpr double duration = 3;  // s
constexpr double length = 0.5;  // m, of a plank
constexpr double thick = 0.1;   // m

int half(const Parameters& p) { return static_cast<int>(p.at("half")); }

// The chain in equilibrium, from its middle to the right bank. The horizontal pull H is the same everywhere; the
// vertical pull at the middle of plank j is half the load plus j - 1/2 planks, and the plank lies along the pull.
// Forces are in units of a plank's weight. H is found from the span, which increases with it, by bisection to the last
// bit.
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

// Hinged to a bank at each end; the load hangs from the middle hinge by its centre.
Scene scene(const Parameters& p) {
  const auto right = catenary(p);
  std::vector<Vec> points;
  for (auto point = right.rbegin(); point != right.rend(); ++point) points.push_back({-point->x, point->y});
  points.insert(points.end(), right.begin() + 1, right.end());

  Scene scene{
      .name = "rope-bridge", .about = "A bridge of hinged planks carries a load in its middle.", .duration = duration};
  chains::add_links(scene, points, thick);
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

// Nothing moves. If each hinge lengthens the chain by its slop, the middle sinks by their sum divided by the sine of
// the smallest slope, which is where the tilts of all planks add up. Hinges that are springs lengthen it by the pull of
// the chain, along the planks, with the inverse mass 2/m. It does not move sideways because the scene is its own mirror
// image.
std::vector<Expectation> expectations(const Parameters& p) {
  const auto chain = catenary(p);
  const double hinges = half(p) + 1;
  const double least = chain[1].y / length;
  const double reach = length * half(p) + 1;
  double pulls = 0;  // of all hinges of a half, in weights of a plank
  const double level = (p.at("ratio") / 2 + 0.5) * chain[1].x / chain[1].y;
  for (int j = 0; j <= half(p); ++j) pulls += std::hypot(level, p.at("ratio") / 2 + j);
  const auto longer = [=](const Stepping& s) {
    return hinges * s.joint_slop + spring_depth(s.joint_frequency, pulls * standard_gravity, 2);
  };
  return {{.body = "load",
           .quantity = Quantity::y,
           .expected = 0,
           .allowed = [=](const Stepping& s) { return longer(s) / least + round_off(s, duration, reach) / least; },
           .source = "equilibrium: H and the weights give each slope; one slop or spring per hinge"},
          {.body = "load",
           .quantity = Quantity::x,
           .expected = 0,
           .allowed = [=](const Stepping& s) { return longer(s) + round_off(s, duration, reach) / least; },
           .source = "symmetry"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "rope-bridge",
     .question = "Does a bridge of planks hang under a heavy load where statics says?",
     .parameters = {{.name = "half",
                     .value = 6,
                     .min = 1,
                     .max = 100,
                     .about = "planks from the middle to each bank",
                     .whole = true},
                    {.name = "ratio",
                     .value = 50,
                     .min = 1,
                     .max = 10000,
                     .about = "mass of the load divided by that of a plank"},
                    {.name = "tight", .value = 0.9, .min = 0.3, .max = 0.99, .about = "span divided by length"}},
     .variants = {{"light", {{"ratio", 1}}}, {"heavy", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::rope_bridge
