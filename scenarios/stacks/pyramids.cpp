#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::pyramids {
namespace {

// Boxes of 1 m, `base` of them in the lowest row and one less in each row above, a quarter of a box apart, on the
// ground and centred on `x`. They are named "<prefix>row.place", both counted from 1.
std::vector<Body> pyramid_of(const std::string& prefix, int base, double x, Surface of) {
  constexpr double pitch = 1.25;  // m, from box to box
  std::vector<Body> boxes;
  for (int row = 1; row <= base; ++row) {
    const int width = base - row + 1;
    for (int place = 1; place <= width; ++place) {
      const Vec center{x + (place - (width + 1) / 2.0) * pitch, row - 0.5};
      boxes.push_back(box(prefix + std::to_string(row) + "." + std::to_string(place), center, {1, 1}, of));
    }
  }
  return boxes;
}

// m, by which the boxes of a row, counted from 1, sink where contacts are springs, `base` boxes in the lowest. A box
// bears its own weight and half of what each of two above it bears; the sum takes the most loaded box of every row. On
// the ground it stands on two corners, as in a tower. On two boxes it stands on four points, 1/2 m and 1/8 m from the
// middles of the two bodies there: 1/m + r^2/I, I = m/6, of both is 3.59/m.
double row_sinks(const Stepping& s, double mass, int base, int row) {
  std::vector<double> most;  // in weights, by row from the apex
  std::vector<double> borne{1};
  for (int width = 1; width <= base; ++width) {
    most.push_back(*std::max_element(borne.begin(), borne.end()));
    std::vector<double> below(borne.size() + 1, 1);
    for (std::size_t i = 0; i < borne.size(); ++i) {
      below[i] += borne[i] / 2;
      below[i + 1] += borne[i] / 2;
    }
    borne = below;
  }
  const double weight = mass * standard_gravity;
  double sinks = 0;
  for (int i = 1; i <= row; ++i) {
    const double load = most[static_cast<std::size_t>(base - i)] * weight;
    const double beside = 2 + 6 * (0.5 * 0.5 + 0.125 * 0.125);
    sinks += i == 1 ? spring_depth(s.fixed_contact_frequency, load / 2, 2.5 / mass)
                    : spring_depth(s.contact_frequency, load / 4, beside / mass);
  }
  return sinks;
}

// Every box of the pyramid stays at its height for `duration`, s, and the apex on its vertical. Every box rests on two
// below it, to the outside of their middles on both sides, and carries its load the same way: all resultant forces lie
// between the supports, and nothing moves. As in a tower, box by box up to row k: k gaps or depths of springs in
// height, and a lean of slop/size per row, which moves the apex k (k+1)/2 slop to the side.
std::vector<Expectation> pyramid_stands(const std::vector<Body>& pyramid, double duration) {
  std::vector<Expectation> all;
  const int base = static_cast<int>(pyramid.back().position.y + 0.5);
  for (const Body& one : pyramid) {
    const double row = one.position.y + 0.5;
    const double reach = std::abs(one.position.x) + row;
    const double mass = mass_of(one).mass;
    all.push_back({.body = one.name,
                   .quantity = Quantity::y,
                   .expected = one.position.y,
                   .allowed =
                       [=](const Stepping& s) {
                         return row * s.contact_gap() + row_sinks(s, mass, base, static_cast<int>(row)) +
                                round_off(s, duration, reach);
                       },
                   .source = "equilibrium: does not move, within one gap or depth of its spring per contact below"});
  }
  const Body& apex = pyramid.back();
  const double row = apex.position.y + 0.5;
  all.push_back(
      {.body = apex.name,
       .quantity = Quantity::x,
       .expected = apex.position.x,
       .allowed = [=, reach = std::abs(apex.position.x) + row](
                      const Stepping& s) { return row * (row + 1) / 2 * s.slop + round_off(s, duration, reach); },
       .source = "equilibrium: leans at most by one slop per contact"});
  return all;
}

}  // namespace
}  // namespace plumb::scenarios::pyramids

namespace plumb::scenarios::pyramid {
namespace {

constexpr double friction = 0.5;

int base_of(const Parameters& p) { return static_cast<int>(p.at("base")); }

Scene scene(const Parameters& p) {
  const Surface wood = surface(friction, 0);
  Scene scene{.name = "pyramid",
              .about = "A pyramid of boxes, each standing on two of the row below.",
              .duration = p.at("duration")};
  scene.bodies = pyramids::pyramid_of("box ", base_of(p), 0, wood);
  scene.bodies.insert(scene.bodies.begin(), level_ground(wood));
  return scene;
}

std::vector<Expectation> expectations(const Parameters& p) {
  return pyramids::pyramid_stands(pyramids::pyramid_of("box ", base_of(p), 0, surface(friction, 0)), p.at("duration"));
}

const Catalog<Scenario>::Entry entry{
    {.name = "pyramid",
     .question = "Does a pyramid of boxes stand?",
     .parameters =
         {{.name = "base", .value = 10, .min = 1, .max = 100, .about = "boxes in the lowest row", .whole = true},
          {.name = "duration",
           .value = 3,
           .min = 0.1,
           .max = 100,
           .unit = "s",
           .about = "time for which it must stand"}},
     .variants = {{"five", {{"base", 5}}}, {"ten", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::pyramid

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
    all.push_back(pyramids::pyramid_of(std::to_string(i) + ": ", base, x, surface(0.5, 0)));
  }
  return all;
}

Scene scene(const Parameters& p) {
  Scene scene{
      .name = "many-pyramids", .about = "A row of pyramids that do not touch each other.", .duration = duration};
  scene.bodies.push_back(level_ground(surface(0.5, 0)));
  for (const auto& pyramid : pyramids(p)) scene.bodies.insert(scene.bodies.end(), pyramid.begin(), pyramid.end());
  return scene;
}

std::vector<Expectation> expectations(const Parameters& p) {
  std::vector<Expectation> all;
  for (const auto& pyramid : pyramids(p)) {
    const auto stands = pyramids::pyramid_stands(pyramid, duration);
    all.insert(all.end(), stands.begin(), stands.end());
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "many-pyramids",
     .question = "Do many separate pyramids all stand?",
     .parameters = {{.name = "count", .value = 6, .min = 1, .max = 200, .about = "number of pyramids", .whole = true},
                    {.name = "base",
                     .value = 4,
                     .min = 1,
                     .max = 20,
                     .about = "boxes in the lowest row of each pyramid",
                     .whole = true}},
     .variants = {{"six", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::many_pyramids

namespace plumb::scenarios::teams {
namespace {

constexpr double duration = 2;  // s

int base_of(const Parameters& p) { return static_cast<int>(p.at("base")); }

// The distance of each pyramid from the middle, chosen so that the two have just swapped places at the end.
double start(const Parameters& p) { return p.at("speed") * duration / 2; }

// On frictionless ground each pyramid moves as one.
std::vector<Body> team(const Parameters& p, double side) {
  auto boxes = pyramids::pyramid_of(side < 0 ? "left " : "right ", base_of(p), side * start(p), surface(0.5, 0));
  for (Body& body : boxes) {
    body.velocity = {-side * p.at("speed"), 0};
    body.layers = side < 0 ? 1 : 2;
  }
  return boxes;
}

Scene scene(const Parameters& p) {
  Scene scene{.name = "teams",
              .about = "Two pyramids on separate layers slide through each other on frictionless ground.",
              .duration = duration};
  scene.bodies.push_back(level_ground(surface(0, 0)));
  for (const double side : {-1.0, 1.0}) {
    const auto boxes = team(p, side);
    scene.bodies.insert(scene.bodies.end(), boxes.begin(), boxes.end());
  }
  return scene;
}

// In its own moving frame a pyramid stands still: each box is where it stood plus v t, within what a pyramid may
// settle, one gap per row in height and k (k+1)/2 slop to the side up to row k.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  std::vector<Expectation> all;
  for (const double side : {-1.0, 1.0}) {
    for (const Body& body : team(p, side)) {
      const double row = body.position.y + 0.5;
      const auto exact = [=, x = std::abs(body.position.x)](const Stepping& s) {
        return round_off(s, duration, x + row + v * duration);
      };
      all.push_back({.body = body.name,
                     .quantity = Quantity::x,
                     .expected = body.position.x - side * v * duration,
                     .allowed = [=](const Stepping& s) { return row * (row + 1) / 2 * s.slop + exact(s); },
                     .source = "v t, as if the other pyramid did not exist"});
      all.push_back({.body = body.name,
                     .quantity = Quantity::y,
                     .expected = body.position.y,
                     .allowed = [=](const Stepping& s) { return row * s.contact_gap() + exact(s); },
                     .source = "stays at its height: touches the ground, not the other pyramid"});
    }
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "teams",
     .question = "Do two pyramids on separate layers pass through each other while standing on the same ground?",
     .parameters = {{.name = "base",
                     .value = 3,
                     .min = 1,
                     .max = 20,
                     .about = "boxes in the lowest row of each pyramid",
                     .whole = true},
                    {.name = "speed", .value = 5, .min = 1, .max = 50, .unit = "m/s", .about = "of each pyramid"}},
     .variants = {{"piles", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::teams
