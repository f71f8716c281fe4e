#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb {
namespace {

constexpr double pitch = 1;  // m

// Hinged to its neighbours half-way; the two upper corners are fixed. They collide with nothing.
Scene scene(const Parameters& p) {
  const int side = static_cast<int>(p.at("side"));
  Scene scene{.name = "joint-grid", .about = "A net of discs, hinged to their neighbours.", .duration = 2};
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const Vec at{(column - (side - 1) / 2.0) * pitch, -row * pitch};
      Body knot = disc(std::to_string(row + 1) + "." + std::to_string(column + 1), at, 0.4, {});
      knot.layers = 0;
      if (row == 0 && (column == 0 || column == side - 1)) knot = fixed(knot);
      scene.bodies.push_back(knot);
      const std::size_t here = scene.bodies.size() - 1;
      if (column > 0) scene.joints.push_back(Revolute{.a = here - 1, .b = here, .anchor = {at.x - pitch / 2, at.y}});
      if (row > 0) {
        const std::size_t above = here - static_cast<std::size_t>(side);
        scene.joints.push_back(Revolute{.a = above, .b = here, .anchor = {at.x, at.y + pitch / 2}});
      }
    }
  }
  return scene;
}

const Catalog<Scenario>::Entry entry{
    {.name = "joint-grid",
     .question = "Does a net of hinged discs hold together as it falls into its corners?",
     .parameters =
         {{.name = "side", .value = 6, .min = 2, .max = 100, .about = "its square are the discs", .whole = true}},
     .variants = {{"six", {}}},
     .scene = scene,
     .expectations = [](const Parameters&) { return std::vector<Expectation>{}; }}};

}  // namespace
}  // namespace plumb
