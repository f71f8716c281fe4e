#include <cmath>
#include <string>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

// Piles of so many boxes, with friction, that an engine may have another path for them; and they move.
namespace plumb::scenarios::sliding_pyramid {
namespace {

constexpr double gravity = 10;    // m/s^2
constexpr double duration = 1.5;  // s
constexpr double pitch = 1.25;    // m, from box to box in a row
constexpr double grip = 0.8;      // coefficient of friction between boxes

int base(const Parameters& p) { return static_cast<int>(p.at("base")); }

std::string name_of(int row, int place) { return "box " + std::to_string(row) + "." + std::to_string(place); }

// Coordinates along the slope and away from it, in the world's frame.
Vec on_slope(const Parameters& p, Vec at) {
  const double a = p.at("angle") * degree;
  return {at.x * std::cos(a) - at.y * std::sin(a), at.x * std::sin(a) + at.y * std::cos(a)};
}

Vec place_of(int base, int row, int place) { return {(place - (base - row + 2) / 2.0) * pitch, row - 0.5}; }

// The smaller coefficient counts: boxes hold on to each other, but not to the slope.
Scene scene(const Parameters& p) {
  const Vec up = on_slope(p, {0, 1});
  Scene scene{.name = "sliding-pyramid",
              .about = "A pyramid of boxes slides down a slope in one piece.",
              .gravity = {0, -gravity},
              .duration = duration,
              .mixing = {.friction = FrictionMixing::min}};
  Surface slippery = surface(p.at("friction"), 0);
  slippery.static_friction += p.at("excess") * (std::tan(p.at("angle") * degree) - p.at("friction"));
  scene.bodies.push_back(half_space("slope", {.normal = up, .offset = 0}, slippery));
  for (int row = 1; row <= base(p); ++row) {
    for (int place = 1; place <= base(p) - row + 1; ++place) {
      Body one = box(name_of(row, place), on_slope(p, place_of(base(p), row, place)), {1, 1}, surface(grip, 0));
      one.angle = p.at("angle") * degree;
      scene.bodies.push_back(one);
    }
  }
  return scene;
}

// Every box moves with a = g (sin a - mu cos a), as one on the slope would alone: then the slope's friction, mu times
// the whole weight's normal part, is what decelerates the whole. Seen from the pyramid, gravity leans back by arctan mu
// from the slope's normal. Each box rests on two, whose supports reach from 0.125 to 0.5 m on both sides of its middle,
// and as long as mu times half its height is less than that, its load lies between them; between boxes the same lean
// needs a friction of mu, less than their own. More friction while sticking changes nothing, as the slope is too steep
// for it, tan a > mu_s. Near that limit the errors of the load decide whether a box sticks for a while; the parameter
// ends half-way.
//   contact   detected a lag late, so that friction misses mu g cos a lag of the speed;
//   along     off by the drift of a, by what each row may creep on the one below, and by its lean of 2 gap/size per
//   row; away      off by the gap for each contact below, and by the fall until it is found to touch.
std::vector<Expectation> expectations(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const double mu = p.at("friction");
  const double a = gravity * (std::sin(angle) - mu * std::cos(angle));
  const double t = duration;
  const int n = base(p);
  const double reach = n * pitch + gravity * t * t;
  std::vector<Expectation> all;
  const auto expect = [&](int row, int place) {
    const Vec start = place_of(n, row, place);
    const Vec end = on_slope(p, {start.x - a * t * t / 2, start.y});
    const auto along = [=](const Stepping& s) {
      const double late =
          gravity * mu * std::cos(angle) * lag(s) * t + gravity * std::sin(angle) * lag(s) * (lag(s) + s.h);
      return late + drifted(s, a, t) + row * (row + 1) * s.contact_gap() + row * s.creep * t + round_off(s, t, reach);
    };
    const auto away = [=](const Stepping& s) {
      return row * s.contact_gap() + gravity * std::cos(angle) * lag(s) * (lag(s) + s.h) + round_off(s, t, reach);
    };
    const auto x_error = [=](const Stepping& s) { return std::cos(angle) * along(s) + std::sin(angle) * away(s); };
    const auto y_error = [=](const Stepping& s) { return std::sin(angle) * along(s) + std::cos(angle) * away(s); };
    const auto turn = [=](const Stepping& s) { return 2 * row * s.contact_gap() + round_off(s, t, reach); };
    const std::string name = name_of(row, place);
    const char* law = "slides as one with g (sin a - mu cos a); late contact, drift, gaps and creep of the rows below";
    all.push_back({.body = name, .quantity = Quantity::x, .expected = end.x, .allowed = x_error, .source = law});
    all.push_back({.body = name, .quantity = Quantity::y, .expected = end.y, .allowed = y_error, .source = law});
    all.push_back({.body = name,
                   .quantity = Quantity::angle,
                   .expected = angle,
                   .allowed = turn,
                   .source = "does not topple; leans by a gap on one side, for each row"});
  };
  for (const int place : {1, n}) expect(1, place);
  expect(n / 2, 1);
  expect(n, 1);
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "sliding-pyramid",
     .question = "Does a pile slide down a slope in one piece, as fast as one box?",
     .parameters =
         {{.name = "base", .value = 12, .min = 2, .max = 40, .about = "boxes in the lowest row", .whole = true},
          {.name = "angle", .value = 20, .min = 12, .max = 40, .unit = "deg", .about = "of the slope"},
          {.name = "friction", .value = 0.1, .min = 0, .max = 0.2, .about = "of the slope"},
          {.name = "excess",
           .value = 0,
           .min = 0,
           .max = 0.5,
           .about = "of its friction while sticking, as a share of what would hold the pile"}},
     .variants = {{"78 boxes", {}}, {"smooth", {{"friction", 0}}}, {"sticky", {{"base", 7}, {"excess", 0.4}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::sliding_pyramid

namespace plumb::scenarios::struck_wall {
namespace {

constexpr double duration = 2;  // s
constexpr double size = 0.5;    // m, of a box

// A wall in running bond: every other row is half a box to the side.
Scene scene(const Parameters& p) {
  const Surface brick = surface(0.5, 0);
  const int rows = static_cast<int>(p.at("rows"));
  const int columns = static_cast<int>(p.at("columns"));
  Scene scene{.name = "struck-wall", .about = "A heavy disc knocks down a wall of boxes.", .duration = duration};
  scene.bodies.push_back(level_ground(brick));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double x = (column + (row % 2) / 2.0) * size;
      scene.bodies.push_back(box(std::to_string(row + 1) + "." + std::to_string(column + 1), {x, (row + 0.5) * size},
                                 {size, size}, brick));
    }
  }
  Body ball = disc("ball", {-2.5, rows * size / 2}, 1, surface(0.5, 0, p.at("ratio")));
  ball.velocity = {p.at("speed"), 0};
  scene.bodies.push_back(ball);
  return scene;
}

const Catalog<Scenario>::Entry entry{
    {.name = "struck-wall",
     .question = "Does a wall that is knocked down obey the laws of contact throughout?",
     .parameters = {{.name = "rows", .value = 10, .min = 4, .max = 40, .about = "of the wall", .whole = true},
                    {.name = "columns", .value = 8, .min = 1, .max = 40, .about = "of the wall", .whole = true},
                    {.name = "ratio",
                     .value = 4,
                     .min = 0.1,
                     .max = 100,
                     .about = "density of the ball divided by that of the boxes"},
                    {.name = "speed", .value = 6, .min = 0.1, .max = 50, .unit = "m/s", .about = "of the ball"}},
     .variants = {{"80 boxes", {}}, {"64 boxes", {{"rows", 8}, {"speed", 2}}}},
     .scene = scene,
     .expectations = [](const Parameters&) { return std::vector<Expectation>{}; }}};

}  // namespace
}  // namespace plumb::scenarios::struck_wall
