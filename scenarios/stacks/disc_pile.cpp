#include <numbers>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::disc_pile {
namespace {

constexpr double radius = 0.5;                                 // m
constexpr double rise = 2 * radius * std::numbers::sqrt3 / 2;  // m, from row to row
constexpr double gravity = 10;                                 // m/s^2
constexpr double duration = 3;                                 // s

int rows(const Parameters& p) { return static_cast<int>(p.at("rows")); }
int wide(const Parameters& p) { return static_cast<int>(p.at("wide")); }

// Packed as closely as discs can be, a row as wide as the bin and one in its hollows by turns.
Scene scene(const Parameters& p) {
  Scene scene{.name = "disc-pile",
              .about = "Smooth discs lie in a bin, as close as they can.",
              .gravity = {0, -gravity},
              .duration = duration};
  const Surface smooth = surface(0, 0);
  const std::pair<const char*, Vec> sides[] = {{"floor", {0, 1}}, {"left", {1, 0}}, {"right", {-1, 0}}};
  for (const auto& [name, normal] : sides) {
    Body side = level_ground(smooth);
    side.name = name;
    side.shapes[0].geometry = HalfSpace{.normal = normal, .offset = normal.y == 0 ? -wide(p) * radius : 0};
    scene.bodies.push_back(side);
  }
  for (int row = 0; row < rows(p); ++row) {
    const int count = wide(p) - row % 2;
    for (int i = 0; i < count; ++i) {
      const std::string name = "disc " + std::to_string(row + 1) + "." + std::to_string(i + 1);
      scene.bodies.push_back(disc(name, {(2 * i + 1 - count) * radius, radius + row * rise}, radius, smooth));
    }
  }
  return scene;
}

// Nothing moves, and the floor carries all: smooth walls carry nothing. A contact may stand off by a gap. Two discs
// under one: that raises or lowers it by 2/sqrt 3 of the gap; and where the wide + 1 gaps across a row all fall between
// those two, they are that much farther apart, half of it each, and the one above sinks by 1/sqrt 3 of the half.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene pile = scene(p);
  const double height = radius + (rows(p) - 1) * rise;
  const double gaps = 1 + (rows(p) - 1) * (2 + (wide(p) + 1) / 2.0) / std::numbers::sqrt3;
  const double discs = static_cast<double>(pile.bodies.size() - 3);
  const double weight = discs * mass_of(pile.bodies.back()).mass * gravity;
  return {{.body = pile.bodies.back().name,
           .quantity = Quantity::y,
           .expected = height,
           .allowed = [=](const Stepping& s) { return gaps * s.gap + round_off(s, duration, height); },
           .source = "equilibrium: each row within a gap along its contacts, and what gaps across it let it sink"},
          {.body = "floor",
           .quantity = Quantity::load,
           .over = duration,
           .expected = weight,
           .allowed =
               [=](const Stepping& s) { return weight * (lag(s) + s.h) / duration + round_off(s, duration, weight); },
           .source = "smooth walls carry nothing: N m g in the mean; a lag at the start and the last step"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "disc-pile",
     .question = "Do smooth discs lie still in a bin, with all their weight on its floor?",
     .parameters = {{.name = "wide", .value = 8, .min = 2, .max = 100, .about = "discs side by side", .whole = true},
                    {.name = "rows", .value = 8, .min = 1, .max = 100, .about = "upon each other", .whole = true}},
     .variants = {{"eight", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::disc_pile
