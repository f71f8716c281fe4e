#include <cmath>
#include <numbers>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/random.h"
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

// The densest packing of discs: a row as wide as the bin alternates with a row in its hollows.
Scene scene(const Parameters& p) {
  Scene scene{.name = "disc-pile",
              .about = "Frictionless discs lie in a bin in their densest packing.",
              .gravity = {0, -gravity},
              .duration = duration};
  const Surface smooth = surface(0, 0);
  const std::pair<const char*, Vec> sides[] = {{"floor", {0, 1}}, {"left", {1, 0}}, {"right", {-1, 0}}};
  for (const auto& [name, normal] : sides) {
    const double offset = normal.y == 0 ? -wide(p) * radius : 0;
    scene.bodies.push_back(half_space(name, {.normal = normal, .offset = offset}, smooth));
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

// Nothing moves, and the floor carries all the weight, as frictionless walls carry nothing. A contact may be off by the
// gap. For a disc on two others this raises or lowers it by 2/sqrt 3 of the gap. If all the wide + 1 contacts across a
// row overlap by the slop except those two, these are that much farther apart, half of it each, and the disc above
// sinks by 1/sqrt 3 of the half.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene pile = scene(p);
  const double height = radius + (rows(p) - 1) * rise;
  const double gaps = 1 + (rows(p) - 1) * 2 / std::numbers::sqrt3;
  const double slops = (rows(p) - 1) * (wide(p) + 1) / 2.0 / std::numbers::sqrt3;
  const double discs = static_cast<double>(pile.bodies.size() - 3);
  const double weight = discs * mass_of(pile.bodies.back()).mass * gravity;
  return {
      {.body = pile.bodies.back().name,
       .quantity = Quantity::y,
       .expected = height,
       .allowed =
           [=](const Stepping& s) { return gaps * s.contact_gap() + slops * s.slop + round_off(s, duration, height); },
       .source = "equilibrium: each row off by the gap along its contacts, and sunk by the gaps across it"},
      {.body = "floor",
       .quantity = Quantity::load,
       .over = duration,
       .expected = weight,
       .allowed =
           [=](const Stepping& s) { return weight * (lag(s) + s.h) / duration + round_off(s, duration, weight); },
       .source = "frictionless walls carry nothing: N m g on average; a lag at the start and the last step"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "disc-pile",
     .question = "Do frictionless discs lie still in a bin, with all their weight on its floor?",
     .parameters = {{.name = "wide",
                     .value = 8,
                     .min = 2,
                     .max = 100,
                     .about = "discs side by side in the lowest row",
                     .whole = true},
                    {.name = "rows", .value = 8, .min = 1, .max = 100, .about = "number of rows", .whole = true}},
     .variants = {{"eight", {}}, {"ten", {{"wide", 10}, {"rows", 10}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::disc_pile

namespace plumb::scenarios::rain {
namespace {

constexpr double cell = 1.2;  // m, room for the largest body at any angle
constexpr int columns = 8;

// Boxes and discs alternate, with random sizes and angles, each at a random position in its own cell.
Scene scene(const Parameters& p) {
  Random random(static_cast<std::uint64_t>(p.at("seed")));
  Scene scene{.name = "rain", .about = "Boxes and discs fall into a pit.", .duration = 4};
  scene.bodies.push_back(pit(columns * cell, surface(0.5, 0.2)));
  for (int i = 0; i < static_cast<int>(p.at("count")); ++i) {
    const double across = random.between(0.4, 0.7);
    const double play = (cell - across * std::numbers::sqrt2) / 2;
    const int row = i / columns;
    const int column = i % columns;
    const Vec at{(column - (columns - 1) / 2.0) * cell + random.between(-play, play),
                 (row + 1) * cell + random.between(-play, play)};
    const std::string name = (i % 2 == 0 ? "box " : "disc ") + std::to_string(i + 1);
    Body drop =
        i % 2 == 0 ? box(name, at, {across, across}, surface(0.5, 0.2)) : disc(name, at, across / 2, surface(0.5, 0.2));
    drop.angle = random.between(0, std::numbers::pi / 2);
    scene.bodies.push_back(drop);
  }
  return scene;
}

const Catalog<Scenario>::Entry entry{
    {.name = "rain",
     .question = "Does a rain of boxes and discs come to rest without losing any body?",
     .parameters =
         {{.name = "count", .value = 48, .min = 1, .max = 10000, .about = "number of bodies", .whole = true},
          {.name = "seed", .value = 1, .min = 0, .max = 1e6, .about = "of the random arrangement", .whole = true}},
     .variants = {{"seed 1", {}}, {"seed 2", {{"seed", 2}}}},
     .scene = scene,
     .expectations = [](const Parameters&) { return std::vector<Expectation>{}; }}};

}  // namespace
}  // namespace plumb::scenarios::rain

namespace plumb::scenarios::tumbler {
namespace {

constexpr double duration = 4;     // s
constexpr double pitch = 0.36;     // m, from item to item
constexpr double item = 0.3;       // m, across
constexpr double thickness = 0.3;  // m, of the drum's walls

int count(const Parameters& p, const char* name) { return static_cast<int>(p.at(name)); }

// The inner radius: large enough that the square of items in the drum stays clear of paddles a tenth of the radius
// long.
double radius(const Parameters& p) { return p.at("side") * pitch / std::numbers::sqrt2 / 0.85; }

// A regular polygon of walls, closed at its corners, with paddles that project inwards.
Body drum(const Parameters& p) {
  const Surface steel = surface(0.4, 0);
  const double r = radius(p);
  const int walls = count(p, "walls");
  Body drum{.name = "drum", .type = BodyType::kinematic, .angular_velocity = p.at("turn")};
  const auto add = [&](double angle, double from, double width, double height) {
    const double middle = from + height / 2;
    const Box plank{{width, height}, {middle * std::sin(angle), -middle * std::cos(angle)}, angle};
    drum.shapes.push_back({.geometry = plank, .surface = steel});
  };
  const double half = std::numbers::pi / walls;
  for (int i = 0; i < walls; ++i) add(2 * half * i, r, 2 * (r + thickness) * std::tan(half), thickness);
  const int paddles = count(p, "paddles");
  for (int i = 0; i < paddles; ++i) add(2 * std::numbers::pi * i / paddles, 0.9 * r, 0.1, 0.1 * r);
  return drum;
}

Scene scene(const Parameters& p) {
  Scene scene{.name = "tumbler", .about = "Boxes or discs in a rotating drum.", .duration = duration};
  scene.bodies.push_back(drum(p));
  const int side = count(p, "side");
  const double middle = (side - 1) / 2.0;
  for (int i = 0; i < side * side; ++i) {
    const int row = i / side;
    const int column = i % side;
    const Vec place{(column - middle) * pitch, (row - middle) * pitch};
    const std::string name = "item " + std::to_string(i + 1);
    const Surface wood = surface(0.4, 0.1);
    scene.bodies.push_back(p.at("discs") == 1 ? disc(name, place, item / 2, wood)
                                              : box(name, place, {item, item}, wood));
  }
  return scene;
}

// The drum turns at its prescribed rate, and everything stays within the circle through the inner corners of its walls:
// each coordinate within its radius, to the gap. The items start within .85 of the inner radius r and the paddles reach
// in to .9 r, so that all fall freely for .05 r, with a velocity that every method gets right.
std::vector<Expectation> expectations(const Parameters& p) {
  const double turned = p.at("turn") * duration;
  std::vector<Expectation> all{{.body = "drum",
                                .quantity = Quantity::angle,
                                .expected = turned,
                                .allowed = [=](const Stepping& s) { return round_off(s, duration, turned); },
                                .source = "rotates at the given rate"}};
  const double corner = radius(p) / std::cos(std::numbers::pi / p.at("walls"));
  const double falls = std::floor(60 * std::sqrt(2 * 0.05 * radius(p) / standard_gravity)) / 60;  // s
  const auto inside = [=](const Stepping& s) { return s.contact_gap() + round_off(s, duration, corner); };
  for (int i = 1; i <= count(p, "side") * count(p, "side"); ++i) {
    const std::string name = "item " + std::to_string(i);
    all.push_back({.body = name,
                   .quantity = Quantity::vy,
                   .time = falls,
                   .expected = -standard_gravity * falls,
                   .allowed = [=](const Stepping& s) { return round_off(s, falls, standard_gravity * falls); },
                   .source = "falls freely before it touches anything: -g t"});
    for (const Quantity along : {Quantity::x, Quantity::y}) {
      for (const Relation side : {Relation::at_least, Relation::at_most}) {
        all.push_back({.body = name,
                       .quantity = along,
                       .relation = side,
                       .expected = side == Relation::at_least ? -corner : corner,
                       .allowed = inside,
                       .source = "stays inside the drum, to the gap"});
      }
    }
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "tumbler",
     .question = "Does a rotating drum keep everything inside?",
     .parameters = {{.name = "walls", .value = 4, .min = 3, .max = 64, .about = "walls of the drum", .whole = true},
                    {.name = "paddles",
                     .value = 0,
                     .min = 0,
                     .max = 16,
                     .about = "paddles that project from the walls",
                     .whole = true},
                    {.name = "side",
                     .value = 5,
                     .min = 2,
                     .max = 40,
                     .about = "items along each side of the square inside",
                     .whole = true},
                    {.name = "discs", .value = 0, .min = 0, .max = 1, .about = "1: discs, 0: boxes", .whole = true},
                    {.name = "turn",
                     .value = 0.8,
                     .min = 0.1,
                     .max = 3,
                     .unit = "rad/s",
                     .about = "angular velocity of the drum"}},
     .variants = {{"boxes", {}}, {"washer", {{"walls", 16}, {"paddles", 4}, {"discs", 1}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::tumbler
