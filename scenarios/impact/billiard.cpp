#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::billiard {
namespace {

constexpr double duration = 1.5;  // s
constexpr double radius = 0.5;    // m
constexpr double gap = 0.01;      // m, between two balls: they meet two at a time
constexpr double run_up = 3;      // m, from the cue ball to the foremost
const Vec half_table{12, 8};      // m
const Surface ivory = surface(0, 1);

Body cushions() {
  Body table{.name = "cushions", .type = BodyType::fixed};
  for (const double side : {-1.0, 1.0}) {
    table.shapes.push_back({.geometry = HalfSpace{{side, 0}, -half_table.x}, .surface = ivory});
    table.shapes.push_back({.geometry = HalfSpace{{0, side}, -half_table.y}, .surface = ivory});
  }
  return table;
}

Scene scene(const Parameters& p) {
  Scene scene{.name = "billiard",
              .about = "A ball breaks a triangle of equal ones, without friction or loss.",
              .gravity = {0, 0},
              .duration = duration};
  if (p.at("cushions") == 1) scene.bodies.push_back(cushions());
  Body cue = disc("cue", {-run_up, p.at("offset")}, radius, ivory);
  cue.velocity = {p.at("speed"), 0};
  scene.bodies.push_back(cue);
  const double pitch = 2 * radius + gap;
  for (int row = 1; row <= static_cast<int>(p.at("rows")); ++row) {
    for (int place = 1; place <= row; ++place) {
      const Vec at{(row - 1) * pitch * std::sqrt(3) / 2, (place - (row + 1) / 2.0) * pitch};
      scene.bodies.push_back(disc(std::to_string(row) + "." + std::to_string(place), at, radius, ivory));
    }
  }
  return scene;
}

// Newton's impacts with e = 1, frictionless, keep the energy even where several fall in one step: the work of the
// impulses is the sum of J (v + v')/2, and v' = -v wherever there is one. On the open table nothing acts from outside.
// Sweeps leave a share of that unsolved; a row through the triangle is the longest line of bodies struck together.
// An impact slower than an engine's threshold is treated as inelastic and takes m v^2/4 at most: one for each pair.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene balls = scene(p);
  const double v = p.at("speed");
  const double mass = mass_of(balls.bodies.back()).mass;
  const auto n = static_cast<double>(balls.bodies.size());
  const int rows = static_cast<int>(p.at("rows"));
  const auto exact = [=](const Stepping& s) { return n * mass * round_off(s, duration, v); };
  std::vector<Expectation> all{{.quantity = Quantity::energy,
                                .expected = mass * v * v / 2,
                                .allowed =
                                    [=](const Stepping& s) {
                                      const double slow = std::min(s.restitution_threshold, v);
                                      const double together = mass * v * v * unsolved(s, rows);
                                      return v * exact(s) + together + n * n / 2 * mass * slow * slow / 4;
                                    },
                                .source = "constant, as e = 1"}};
  if (p.at("cushions") == 1) return all;
  all.push_back({.quantity = Quantity::momentum_x, .expected = mass * v, .allowed = exact, .source = "nothing acts"});
  all.push_back({.quantity = Quantity::momentum_y, .expected = 0, .allowed = exact, .source = "nothing acts"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "billiard",
     .question = "Does a break keep energy and momentum?",
     .parameters =
         {{.name = "rows", .value = 5, .min = 1, .max = 9, .about = "of the triangle", .whole = true},
          {.name = "speed", .value = 20, .min = 1, .max = 50, .unit = "m/s", .about = "of the cue ball"},
          {.name = "offset", .value = 0.1, .min = -0.9, .max = 0.9, .unit = "m", .about = "of the cue ball's line"},
          {.name = "cushions", .value = 1, .min = 0, .max = 1, .about = "1: a table, 0: open space", .whole = true}},
     .variants = {{"table", {}}, {"open", {{"cushions", 0}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::billiard
