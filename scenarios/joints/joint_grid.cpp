#include <algorithm>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/sag.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::joint_grid {
namespace {

constexpr double pitch = 1;     // m
constexpr double duration = 2;  // s

const char* const rigid = "rigid: the hinges hold every disc; one slop per hinge";

std::string name(int row, int column) { return std::to_string(row + 1) + "." + std::to_string(column + 1); }
Vec place(int side, int row, int column) { return {(column - (side - 1) / 2.0) * pitch, -row * pitch}; }

// Each disc is hinged to its neighbours at the midpoints; the two upper corners are fixed. They collide with nothing.
Scene scene(const Parameters& p) {
  const int side = static_cast<int>(p.at("side"));
  Scene scene{.name = "joint-grid",
              .about = "A net of discs, each hinged to its neighbours, hangs from its two upper corners.",
              .duration = duration};
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const Vec at = place(side, row, column);
      Body knot = disc(name(row, column), at, 0.4, {});
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

// Hinges on four sides leave the discs only one motion, in which each turns against its neighbours like meshed gears;
// but the corners do not turn. (The hinges' equations for all velocities have full rank for 2 ... 7 discs per side.) So
// nothing moves except by its slop in every hinge: a shift of one slop for each hinge on the way from the nearer
// corner, and a sag like that of a beam whose columns turn by 2 slop/height each, (side/2)^2/2 of those in the middle;
// and what hinges that are springs give way.
std::vector<Expectation> expectations(const Parameters& p) {
  const int side = static_cast<int>(p.at("side"));
  const Scene net = scene(p);
  std::vector<Expectation> all;
  for (int column = 0; column < side; ++column) {
    const double hinges = side - 1 + std::min(column, side - 1 - column);
    const double beam = side * side / (4.0 * (side - 1));
    const auto body = static_cast<std::size_t>((side - 1) * side + column);
    const auto allowed = [=](const Stepping& s) {
      return (hinges + beam) * s.joint_slop + sag(s, net, body) + round_off(s, duration, side * pitch);
    };
    const Vec start = place(side, side - 1, column);
    const std::string knot = name(side - 1, column);
    all.push_back({.body = knot, .quantity = Quantity::x, .expected = start.x, .allowed = allowed, .source = rigid});
    all.push_back({.body = knot, .quantity = Quantity::y, .expected = start.y, .allowed = allowed, .source = rigid});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "joint-grid",
     .question = "Does a net of hinged discs hang rigidly from its corners?",
     .parameters =
         {{.name = "side", .value = 7, .min = 3, .max = 100, .about = "discs along each side", .whole = true}},
     .variants = {{"seven", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::joint_grid
