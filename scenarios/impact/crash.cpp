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
constexpr double gap = 0.01;      // m, between two balls, so that they collide two at a time
constexpr double run_up = 3;      // m, from the cue ball to the foremost ball
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
              .about = "A ball breaks a triangle of equal ones, without friction or energy loss.",
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

// Newton's impacts with e = 1, frictionless, conserve energy even if several happen in one step: the work of the
// impulses is the sum of J (v + v')/2, and v' = -v at each impact. On the open table no external force acts. Iterations
// leave a fraction of that unsolved; the longest line of bodies that collide at once is a row through the triangle. An
// impact slower than an engine's threshold is treated as inelastic and loses at most m v^2/4: one for each pair of
// neighbours in the triangle and the cue ball's; as the balls fly apart, others meet on a table only, one for each
// pair.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene balls = scene(p);
  const double v = p.at("speed");
  const double mass = mass_of(balls.bodies.back()).mass;
  const auto n = static_cast<double>(balls.bodies.size());
  const int rows = static_cast<int>(p.at("rows"));
  const double pairs = p.at("cushions") == 1 ? n * n / 2 : 3 * rows * (rows - 1) / 2.0 + 1;
  const auto exact = [=](const Stepping& s) { return n * mass * round_off(s, duration, v); };
  std::vector<Expectation> all{{.quantity = Quantity::energy,
                                .expected = mass * v * v / 2,
                                .allowed =
                                    [=](const Stepping& s) {
                                      const double slow = std::min(s.restitution_threshold, v);
                                      const double together = mass * v * v * unsolved(s, rows);
                                      return v * exact(s) + together + pairs * mass * slow * slow / 4;
                                    },
                                .source = "constant, as e = 1"}};
  if (p.at("cushions") == 1) return all;
  all.push_back({.quantity = Quantity::momentum_x,
                 .expected = mass * v,
                 .allowed = exact,
                 .source = "constant: no external force"});
  all.push_back(
      {.quantity = Quantity::momentum_y, .expected = 0, .allowed = exact, .source = "constant: no external force"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "billiard",
     .question = "Does a billiard break conserve energy and momentum?",
     .parameters = {{.name = "rows", .value = 5, .min = 1, .max = 9, .about = "rows of the triangle", .whole = true},
                    {.name = "speed", .value = 20, .min = 1, .max = 50, .unit = "m/s", .about = "of the cue ball"},
                    {.name = "offset",
                     .value = 0.1,
                     .min = -0.9,
                     .max = 0.9,
                     .unit = "m",
                     .about = "of the cue ball's line from the centre line"},
                    {.name = "cushions",
                     .value = 1,
                     .min = 0,
                     .max = 1,
                     .about = "1: a table with cushions, 0: open space",
                     .whole = true}},
     .variants = {{"table", {}}, {"open", {{"cushions", 0}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::billiard

namespace plumb::scenarios::smash {
namespace {

constexpr double duration = 1.5;  // s
constexpr double size = 0.4;      // m, of a small box
constexpr double pitch = 0.41;    // m, from box to box
constexpr double start = -3;      // m

// No gravity: forces act between the bodies only.
Scene scene(const Parameters& p) {
  const Surface stone = surface(0.4, 0);
  const int rows = static_cast<int>(p.at("rows"));
  const int columns = static_cast<int>(p.at("columns"));
  Scene scene{.name = "smash",
              .about = "A heavy box hits a wall of small ones, without gravity.",
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

// Contact forces are equal and opposite: momentum is constant, however late an engine detects the contacts. (So is
// angular momentum, but correcting penetrations may change it, by an amount that depends on how late they were.)
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene all = scene(p);
  const double momentum = mass_of(all.bodies.front()).mass * p.at("speed");
  const double share = static_cast<double>(all.bodies.size());
  const auto exact = [=](const Stepping& s) { return share * round_off(s, duration, momentum); };
  return {{.quantity = Quantity::momentum_x,
           .expected = momentum,
           .allowed = exact,
           .source = "constant: no external force"},
          {.quantity = Quantity::momentum_y, .expected = 0, .allowed = exact, .source = "constant: no external force"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "smash",
     .question = "Does a crash of many bodies conserve momentum?",
     .parameters =
         {{.name = "rows", .value = 8, .min = 1, .max = 100, .about = "rows of the wall", .whole = true},
          {.name = "columns", .value = 6, .min = 1, .max = 100, .about = "columns of the wall", .whole = true},
          {.name = "ratio",
           .value = 8,
           .min = 0.1,
           .max = 1000,
           .about = "density of the big box divided by that of the small ones"},
          {.name = "speed", .value = 10, .min = 1, .max = 50, .unit = "m/s", .about = "of the big box"}},
     .variants = {{"wall", {}}, {"144 boxes", {{"rows", 12}, {"columns", 12}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::smash
