#include <algorithm>
#include <cmath>
#include <string>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

// The towers of the classical comparison of physics engines (A. Boeing, T. Braeunl, GRAPHITE 2007), and one that has
// yet to come to rest.
namespace plumb::scenarios::tower_row {
namespace {

constexpr double size = 0.5;  // m, of a box
constexpr double apart = 1;   // m, from tower to tower
constexpr double friction = 0.5;
constexpr int highest_by_place = 7;

std::string name(int tower, int box) { return "box " + std::to_string(box) + " of " + std::to_string(tower); }

Scene scene(const Parameters& p) {
  const Surface rough = surface(friction, 0);
  Scene scene{.name = "tower-row",
              .about = "Towers of one box, of two, and so on stand side by side.",
              .duration = p.at("duration")};
  scene.bodies.push_back(level_ground(rough));
  for (int tower = 1; tower <= static_cast<int>(p.at("towers")); ++tower) {
    for (int k = 1; k <= tower; ++k)
      scene.bodies.push_back(box(name(tower, k), {apart * tower, (k - 0.5) * size}, {size, size}, rough));
  }
  return scene;
}

// As in "stacking": nothing moves, within one gap per contact below or, where contacts are springs, their depths, and
// the lean of one slop per contact. To the side that adds up as the square of the contacts, so of a tall tower a lower
// box is asked for.
std::vector<Expectation> expectations(const Parameters& p) {
  const double end = p.at("duration");
  std::vector<Expectation> all;
  for (int tower = 1; tower <= static_cast<int>(p.at("towers")); ++tower) {
    const double reach = tower * (apart + size) + 1;
    const int low = std::min(tower, highest_by_place);
    const std::vector<double> masses(static_cast<std::size_t>(tower), size * size);
    all.push_back({.body = name(tower, tower),
                   .quantity = Quantity::y,
                   .expected = (tower - 0.5) * size,
                   .allowed =
                       [=](const Stepping& s) {
                         return tower * s.contact_gap() + tower_sinks(s, standard_gravity, masses, masses.size()) +
                                round_off(s, end, reach);
                       },
                   .source = "stands: one gap or depth of its spring per contact below"});
    all.push_back({.body = name(tower, tower),
                   .quantity = Quantity::angle,
                   .expected = 0,
                   .allowed = [=](const Stepping& s) { return tower * s.slop / size + round_off(s, end, reach); },
                   .source = "stands: leans by at most one slop per contact"});
    all.push_back(
        {.body = name(tower, low),
         .quantity = Quantity::x,
         .expected = apart * tower,
         .allowed = [=](const Stepping& s) { return low * (low + 1) / 2.0 * s.slop + round_off(s, end, reach); },
         .source = "stands: leans by at most one slop per contact below"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "tower-row",
     .question = "Do towers of 1, 2, ... 18 boxes all stand?",
     .parameters =
         {{.name = "towers", .value = 18, .min = 1, .max = 30, .about = "boxes of the tallest", .whole = true},
          {.name = "duration", .value = 3, .min = 1, .max = 60, .unit = "s", .about = "for which they must stand"}},
     .variants = {{"18", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::tower_row

namespace plumb::scenarios::settling_tower {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double size = 1;      // m, of a box
constexpr double friction = 0.5;
constexpr double duration = 3;  // s

std::string name(int k) { return "box " + std::to_string(k); }

Scene scene(const Parameters& p) {
  const Surface rough = surface(friction, 0);
  Scene scene{.name = "settling-tower",
              .about = "Boxes above one another fall into a tower.",
              .gravity = {0, -gravity},
              .duration = duration};
  scene.bodies.push_back(level_ground(rough));
  for (int k = 1; k <= static_cast<int>(p.at("boxes")); ++k)
    scene.bodies.push_back(box(name(k), {0, (k - 0.5) * size + k * p.at("gap")}, {size, size}, rough));
  return scene;
}

// The boxes fall together until the lowest is on the ground, then the next is on it, and so on: each impact is one of
// two flat faces with e = 0, and ends in rest. Box k has come down by k times the gap. At rest it is within one gap of
// the engine, or the depth of a spring, per contact below. It may still sink by the gaps, on average as fast as in all
// of the time.
std::vector<Expectation> expectations(const Parameters& p) {
  const int boxes = static_cast<int>(p.at("boxes"));
  const std::vector<double> masses(static_cast<std::size_t>(boxes), size * size);
  std::vector<Expectation> all;
  for (int k = 1; k <= boxes; ++k) {
    const double reach = (k + 1) * size + gravity * duration;
    all.push_back({.body = name(k),
                   .quantity = Quantity::y,
                   .expected = (k - 0.5) * size,
                   .allowed =
                       [=](const Stepping& s) {
                         return k * s.contact_gap() + tower_sinks(s, gravity, masses, static_cast<std::size_t>(k)) +
                                round_off(s, duration, reach);
                       },
                   .source = "lies on the one below; one gap or depth of its spring per contact below"});
    all.push_back(
        {.body = name(k),
         .quantity = Quantity::speed,
         .expected = 0,
         .allowed = [=](const Stepping& s) { return k * s.contact_gap() / duration + round_off(s, duration, reach); },
         .source = "at rest; it may sink by one gap per contact below"});
  }
  all.push_back({.body = name(boxes),
                 .quantity = Quantity::x,
                 .expected = 0,
                 .allowed =
                     [=](const Stepping& s) {
                       return boxes * (boxes + 1) / 2.0 * s.slop + round_off(s, duration, (boxes + 1) * size);
                     },
                 .source = "stands: leans by at most one slop per contact"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "settling-tower",
     .question = "Do ten boxes that fall on one another lie still after 3 s?",
     .parameters = {{.name = "boxes", .value = 10, .min = 1, .max = 15, .about = "in the tower", .whole = true},
                    {.name = "gap", .value = 0.02, .min = 0.001, .max = 0.05, .unit = "m", .about = "below each box"}},
     .variants = {{"ten", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::settling_tower
