#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::flush_tiles {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 2;  // s
const Vec tile{1, 0.5};         // m
const Vec size{2, 0.5};         // m; too low to tip: mu < b/h = 4

// The box's speed is told as the tiles see it, which move along themselves.
double distance(const Parameters& p) { return p.at("speed") * duration; }  // m, at most

Scene scene(const Parameters& p) {
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "flush-tiles",
              .about = "A box slides over a row of flush tiles.",
              .gravity = {0, -gravity},
              .duration = duration};
  const int tiles = static_cast<int>(std::ceil(distance(p) / tile.x)) + 3;
  for (int i = 0; i < tiles; ++i) {
    scene.bodies.push_back(box("tile " + std::to_string(i), {(i - 1) * tile.x, -tile.y / 2}, tile, rough));
    scene.bodies.back().type = p.at("tiles") == 0 ? BodyType::fixed : BodyType::kinematic;
    scene.bodies.back().velocity = {p.at("tiles"), 0};
  }
  Body sliding = box("box", {0, size.y / 2}, size, rough);
  sliding.velocity = {p.at("speed") + p.at("tiles"), 0};
  scene.bodies.push_back(sliding);
  return scene;
}

// As on one continuous floor: v - mu g t. Contact may be found a lag late, and the deceleration has its drift. Where
// one end is deeper by the slop, the box tilts by slop/b, and so may the direction of the contact force; but all tiles
// let it in equally, so no side of a tile sticks out for it to hit.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double slowing = p.at("friction") * gravity;
  const double carried = p.at("tiles");
  const double reach = distance(p) + (v + std::abs(carried)) * duration;
  const double slides = slowing > 0 ? std::min(v / slowing, duration) : duration;  // s
  // A closed form knows where the box is on tiles that stand.
  const auto expected = [=](double value) { return carried == 0 ? std::nullopt : std::optional(value); };
  const auto speed = [=](const Stepping& s) {
    return gravity * s.slop / size.x * duration + round_off(s, duration, v + std::abs(carried));
  };
  const auto place = [=, mu = p.at("friction")](const Stepping& s) {
    return speed(s) * duration + drifted(s, slowing, duration) + slid_late(s, slowing) + mu * s.slop +
           round_off(s, duration, reach);
  };
  const auto height = [=](const Stepping& s) {
    return s.contact_gap() + gravity * lag(s) * (lag(s) + s.h) + round_off(s, duration, reach);
  };
  const auto turn = [=](const Stepping& s) { return s.slop / size.x + round_off(s, duration, reach / size.x); };
  return {{.body = "box",
           .quantity = Quantity::vx,
           .expected = expected(carried + v - slowing * slides),
           .allowed = speed,
           .source = "v - mu g t; tilted by the slop"},
          {.body = "box",
           .quantity = Quantity::x,
           .expected = expected(carried * duration + v * slides - slowing * slides * slides / 2),
           .allowed = place,
           .source = "v t - mu g t^2/2; contact a lag late, drift, tilted by the slop"},
          {.body = "box",
           .quantity = Quantity::y,
           .expected = expected(size.y / 2),
           .allowed = height,
           .source = "slides level; the gap, the fall during a lag"},
          {.body = "box",
           .quantity = Quantity::angle,
           .expected = expected(0),
           .allowed = turn,
           .source = "slides level; one end may be deeper by the slop"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "flush-tiles",
     .question = "Does a box slide over flush tiles as over one continuous floor?",
     .parameters = {{.name = "speed", .value = 6, .min = 1, .max = 30, .unit = "m/s", .about = "at the start"},
                    {.name = "friction", .value = 0.1, .min = 0, .max = 1.5, .about = "of box and tiles"},
                    {.name = "tiles", .value = 0, .min = -30, .max = 30, .unit = "m/s", .about = "of the tiles"}},
     .variants =
         {{"smooth", {{"friction", 0}}}, {"mu=0.1", {}}, {"fast", {{"speed", 20}}}, {"moving", {{"tiles", -4}}}},
     .closed_form = "slide",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::flush_tiles
