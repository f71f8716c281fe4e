#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/stacks/pyramid.h"

namespace plumb::scenarios::many_pyramids {
namespace {

constexpr double duration = 2;  // s

std::vector<std::vector<Body>> pyramids(const Parameters& p) {
  const int count = static_cast<int>(p.at("count"));
  const int base = static_cast<int>(p.at("base"));
  const double apart = 1.25 * base + 1;  // m
  std::vector<std::vector<Body>> all;
  for (int i = 1; i <= count; ++i) {
    const double x = (i - (count + 1) / 2.0) * apart;
    all.push_back(pyramid_of(std::to_string(i) + ": ", base, x, surface(0.5, 0)));
  }
  return all;
}

Scene scene(const Parameters& p) {
  Scene scene{.name = "many-pyramids", .about = "A row of pyramids that do not touch.", .duration = duration};
  scene.bodies.push_back(level_ground(surface(0.5, 0)));
  for (const auto& pyramid : pyramids(p)) scene.bodies.insert(scene.bodies.end(), pyramid.begin(), pyramid.end());
  return scene;
}

std::vector<Expectation> expectations(const Parameters& p) {
  std::vector<Expectation> all;
  for (const auto& pyramid : pyramids(p)) {
    const auto stands = pyramid_stands(pyramid, duration);
    all.insert(all.end(), stands.begin(), stands.end());
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "many-pyramids",
     .question = "Do many pyramids stand, each as if alone?",
     .parameters =
         {{.name = "count", .value = 6, .min = 1, .max = 200, .about = "of pyramids", .whole = true},
          {.name = "base", .value = 4, .min = 1, .max = 20, .about = "boxes in the lowest row", .whole = true}},
     .variants = {{"six", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::many_pyramids
