#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::smash {
namespace {

constexpr double duration = 1.5;  // s
constexpr double size = 0.4;      // m, of a small box
constexpr double pitch = 0.41;    // m, from box to box
constexpr double start = -3;      // m

// Weightless: what happens is between the bodies alone.
Scene scene(const Parameters& p) {
  const Surface stone = surface(0.4, 0);
  const int rows = static_cast<int>(p.at("rows"));
  const int columns = static_cast<int>(p.at("columns"));
  Scene scene{.name = "smash",
              .about = "A heavy box is thrown into a wall of small ones, without gravity.",
              .gravity = {0, 0},
              .duration = duration};
  Body big = box("big", {start, 0}, {2, 2}, surface(0.4, 0, p.at("ratio")));
  big.velocity = {p.at("speed"), 0};
  scene.bodies.push_back(big);
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < rows; ++row) {
      const std::string name = std::to_string(column + 1) + "." + std::to_string(row + 1);
      scene.bodies.push_back(box(name, {column * pitch, (row - (rows - 1) / 2.0) * pitch}, {size, size}, stone));
    }
  }
  return scene;
}

// Contacts act on both alike: the momentum is constant, however late an engine sees them. (Angular momentum is too, but
// what lifts bodies out of each other may change it, by as much as they were late.)
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene all = scene(p);
  const double momentum = mass_of(all.bodies.front()).mass * p.at("speed");
  const double share = static_cast<double>(all.bodies.size());
  const auto exact = [=](const Stepping& s) { return share * round_off(s, duration, momentum); };
  return {{.quantity = Quantity::momentum_x, .expected = momentum, .allowed = exact, .source = "nothing acts"},
          {.quantity = Quantity::momentum_y, .expected = 0, .allowed = exact, .source = "nothing acts"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "smash",
     .question = "Does a crash of many bodies keep its momentum?",
     .parameters =
         {{.name = "rows", .value = 8, .min = 1, .max = 100, .about = "of the wall", .whole = true},
          {.name = "columns", .value = 6, .min = 1, .max = 100, .about = "of the wall", .whole = true},
          {.name = "ratio", .value = 8, .min = 0.1, .max = 1000, .about = "density of the big box to the small"},
          {.name = "speed", .value = 10, .min = 1, .max = 50, .unit = "m/s", .about = "of the big box"}},
     .variants = {{"wall", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::smash
