#include <cmath>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

// A pyramid on a slope that friction can hold.
namespace plumb::scenarios::held_pyramid {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 2;  // s
constexpr double pitch = 1.1;   // m, from box to box in a row

int base(const Parameters& p) { return static_cast<int>(p.at("base")); }

std::string name_of(int row, int place) { return "box " + std::to_string(row) + "." + std::to_string(place); }

Vec place_of(const Parameters& p, int row, int place) {
  const double a = p.at("angle") * degree;
  const Vec at{(place - (base(p) - row + 2) / 2.0) * pitch, row - 0.5};
  return {at.x * std::cos(a) - at.y * std::sin(a), at.x * std::sin(a) + at.y * std::cos(a)};
}

Scene scene(const Parameters& p) {
  const double a = p.at("angle") * degree;
  Scene scene{.name = "held-pyramid",
              .about = "A pyramid of boxes stands on a slope, held by static friction alone.",
              .gravity = {0, -gravity},
              .duration = duration};
  const double holds = p.at("hold") * std::tan(a);
  Surface rough = surface(p.at("sliding") * holds, 0);
  rough.static_friction = holds;
  scene.bodies.push_back(half_space("slope", {.normal = {-std::sin(a), std::cos(a)}, .offset = 0}, rough));
  for (int row = 1; row <= base(p); ++row) {
    for (int place = 1; place <= base(p) - row + 1; ++place) {
      Body one = box(name_of(row, place), place_of(p, row, place), {1, 1}, rough);
      one.angle = a;
      scene.bodies.push_back(one);
    }
  }
  return scene;
}

// Let every contact bear straight against gravity: then each asks for a friction of tan a times its load, less than the
// static coefficient, and loads add up from row to row. Through a box they pass along gravity, so they leave its lower
// face tan a of its height further down the slope than they came in, still within that face (a test carries them from
// the top to the slope). So nothing moves, although masses do not say how a box shares its load between the two below,
// and sliding friction would not bear it: a contact that bears all of its static friction has not slid yet.
//   along     what a box slides until its contact is found and stopped, what each row may creep on the one below, and
//             its lean of 2 gap/size per row;
//   away      the gap for each contact below, and the fall until it is found to touch.
std::vector<Expectation> expectations(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const int n = base(p);
  const double reach = n * pitch;
  std::vector<Expectation> all;
  const auto expect = [&](int row, int place) {
    const Vec at = place_of(p, row, place);
    const auto along = [=](const Stepping& s) {
      return gravity * std::sin(angle) * lag(s) * (lag(s) + s.h) + row * (row + 1) * s.contact_gap() +
             row * s.creep * duration + round_off(s, duration, reach);
    };
    const auto away = [=](const Stepping& s) {
      return row * s.contact_gap() + gravity * std::cos(angle) * lag(s) * (lag(s) + s.h) +
             round_off(s, duration, reach);
    };
    const auto x_error = [=](const Stepping& s) { return std::cos(angle) * along(s) + std::sin(angle) * away(s); };
    const auto y_error = [=](const Stepping& s) { return std::sin(angle) * along(s) + std::cos(angle) * away(s); };
    const std::string name = name_of(row, place);
    const char* law = "statics: every contact bears straight against gravity, with a friction of tan a times its load";
    all.push_back({.body = name, .quantity = Quantity::x, .expected = at.x, .allowed = x_error, .source = law});
    all.push_back({.body = name, .quantity = Quantity::y, .expected = at.y, .allowed = y_error, .source = law});
  };
  for (const int place : {1, n}) expect(1, place);
  expect((n + 1) / 2, 1);
  expect(n, 1);
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "held-pyramid",
     .question = "Does static friction hold a pile on a slope that sliding friction would not?",
     .parameters = {{.name = "base", .value = 6, .min = 2, .max = 8, .about = "boxes in the lowest row", .whole = true},
                    {.name = "angle", .value = 13, .min = 5, .max = 20, .unit = "deg", .about = "of the slope"},
                    {.name = "hold",
                     .value = 1.5,
                     .min = 1.3,
                     .max = 3,
                     .about = "static coefficient, as a multiple of what holds one box"},
                    {.name = "sliding",
                     .value = 0.5,
                     .min = 0,
                     .max = 1,
                     .about = "dynamic coefficient, as a share of the static one"}},
     .variants = {{"21 boxes", {}}, {"10 boxes", {{"base", 4}}}, {"one coefficient", {{"sliding", 1}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::held_pyramid
