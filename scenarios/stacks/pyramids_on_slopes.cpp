#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

// Pyramids of boxes of 1 m on slopes, of so many boxes that an engine may have another path for them. Parameters have
// their `base`, the boxes in the lowest row, and the `angle` of the slope in degrees.
namespace plumb::scenarios {
namespace {

constexpr double gravity = 10;  // m/s^2

int base(const Parameters& p) { return static_cast<int>(p.at("base")); }
double angle(const Parameters& p) { return p.at("angle") * degree; }

std::string name_of(int row, int place) { return "box " + std::to_string(row) + "." + std::to_string(place); }

// Coordinates along the slope and away from it, in the world's frame.
Vec on_slope(const Parameters& p, Vec at) {
  const double a = angle(p);
  return {at.x * std::cos(a) - at.y * std::sin(a), at.x * std::sin(a) + at.y * std::cos(a)};
}

// Of a box, in coordinates of the slope. `pitch`: m, from box to box in a row.
Vec place_of(int base, double pitch, int row, int place) {
  return {(place - (base - row + 2) / 2.0) * pitch, row - 0.5};
}

void add_pyramid(Scene& scene, const Parameters& p, double pitch, const Surface& of_slope, const Surface& of_boxes) {
  scene.bodies.push_back(half_space("slope", {.normal = on_slope(p, {0, 1}), .offset = 0}, of_slope));
  for (int row = 1; row <= base(p); ++row) {
    for (int place = 1; place <= base(p) - row + 1; ++place) {
      Body one = box(name_of(row, place), on_slope(p, place_of(base(p), pitch, row, place)), {1, 1}, of_boxes);
      one.angle = angle(p);
      scene.bodies.push_back(one);
    }
  }
}

// What a box of a row may be off by, t seconds after the start:
//   along the slope   what it slides until its contact is found, what each row may creep on the one below, and its lean
//                     of 2 gap/size per row;
//   away from it      the gap for each contact below, and the fall until it is found to touch.
struct Off {
  double along = 0, away = 0;  // m

  Off(const Parameters& p, const Stepping& s, int row, double t, double reach)
      : along(gravity * std::sin(angle(p)) * lag(s) * (lag(s) + s.h) + row * (row + 1) * s.contact_gap() +
              row * s.creep * t + round_off(s, t, reach)),
        away(row * s.contact_gap() + gravity * std::cos(angle(p)) * lag(s) * (lag(s) + s.h) + round_off(s, t, reach)) {}
};

// Asks where a box is, in the world's frame. `off`: how far from there it may be, by how an engine steps.
void expect_at(std::vector<Expectation>& all, const Parameters& p, const std::string& name, Vec at,
               const std::function<Off(const Stepping&)>& off, const char* law) {
  const double c = std::cos(angle(p));
  const double s = std::sin(angle(p));
  const auto x_off = [=](const Stepping& by) { return c * off(by).along + s * off(by).away; };
  const auto y_off = [=](const Stepping& by) { return s * off(by).along + c * off(by).away; };
  all.push_back({.body = name, .quantity = Quantity::x, .expected = at.x, .allowed = x_off, .source = law});
  all.push_back({.body = name, .quantity = Quantity::y, .expected = at.y, .allowed = y_off, .source = law});
}

}  // namespace

namespace sliding_pyramid {
namespace {

constexpr double duration = 1.5;  // s
constexpr double pitch = 1.25;    // m
constexpr double grip = 0.8;      // coefficient of friction between boxes
// Row above which boxes may lean by more than a twentieth of the way, with gaps of half a millimetre: a check of those
// would be none.
constexpr int highest_asked = 12;

// The smaller coefficient counts: boxes hold on to each other, but not to the slope.
Scene scene(const Parameters& p) {
  Scene scene{.name = "sliding-pyramid",
              .about = "A pyramid of boxes slides down a slope in one piece.",
              .gravity = {0, -gravity},
              .duration = duration,
              .mixing = {.friction = FrictionMixing::min}};
  Surface slippery = surface(p.at("friction"), 0);
  slippery.static_friction += p.at("excess") * (std::tan(angle(p)) - p.at("friction"));
  add_pyramid(scene, p, pitch, slippery, surface(grip, 0));
  return scene;
}

// Every box moves with a = g (sin a - mu cos a), as one on the slope would alone: then the slope's friction, mu times
// the whole weight's normal part, is what decelerates the whole. Seen from the pyramid, gravity leans back by arctan mu
// from the slope's normal. Each box rests on two, whose supports reach from 0.125 to 0.5 m on both sides of its middle,
// and as long as mu times half its height is less than that, its load lies between them; between boxes the same lean
// needs a friction of mu, less than their own. More friction while sticking changes nothing, as the slope is too steep
// for it, tan a > mu_s. Near that limit the errors of the load decide whether a box sticks for a while; the parameter
// ends half-way. What is found to touch late misses friction, mu g cos a lag of the speed, and what moves drifts.
std::vector<Expectation> expectations(const Parameters& p) {
  const double mu = p.at("friction");
  const double cosine = std::cos(angle(p));
  const double a = gravity * (std::sin(angle(p)) - mu * cosine);
  const double t = duration;
  const int n = base(p);
  const double reach = n * pitch + gravity * t * t;
  std::vector<Expectation> all;
  const auto expect = [&](int row, int place) {
    const Vec start = place_of(n, pitch, row, place);
    const Vec end = on_slope(p, {start.x - a * t * t / 2, start.y});
    const auto off = [=](const Stepping& s) {
      Off most(p, s, row, t, reach);
      most.along += gravity * mu * cosine * lag(s) * t + drifted(s, a, t);
      return most;
    };
    const auto turn = [=](const Stepping& s) { return 2 * row * s.contact_gap() + round_off(s, t, reach); };
    const std::string name = name_of(row, place);
    const char* law = "slides as one with g (sin a - mu cos a); late contact, drift, gaps and creep of the rows below";
    expect_at(all, p, name, end, off, law);
    all.push_back({.body = name,
                   .quantity = Quantity::angle,
                   .expected = angle(p),
                   .allowed = turn,
                   .source = "does not topple; leans by a gap on one side, for each row"});
  };
  for (const int place : {1, n}) expect(1, place);
  expect(n / 2, 1);
  expect(std::min(n, highest_asked), 1);
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
     .variants = {{"78 boxes", {}},
                  {"smooth", {{"friction", 0}}},
                  {"sticky", {{"base", 7}, {"excess", 0.4}}},
                  {"300 boxes", {{"base", 24}, {"excess", 0.2}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace sliding_pyramid

namespace held_pyramid {
namespace {

constexpr double duration = 2;  // s
constexpr double pitch = 1.1;   // m

Scene scene(const Parameters& p) {
  Scene scene{.name = "held-pyramid",
              .about = "A pyramid of boxes stands on a slope, held by static friction alone.",
              .gravity = {0, -gravity},
              .duration = duration};
  const double holds = p.at("hold") * std::tan(angle(p));
  Surface rough = surface(p.at("sliding") * holds, 0);
  rough.static_friction = holds;
  add_pyramid(scene, p, pitch, rough, rough);
  return scene;
}

// Let every contact bear straight against gravity: then each asks for a friction of tan a times its load, less than the
// static coefficient, and loads add up from row to row. Through a box they pass along gravity, so they leave its lower
// face tan a of its height further down the slope than they came in, still within that face (a test carries them from
// the top to the slope). So nothing moves, although masses do not say how a box shares its load between the two below,
// and sliding friction may not bear it: a contact that bears all of its static friction has not slid yet. That is so
// for every coefficient above tan a; the nearer, the better a method must know the loads.
std::vector<Expectation> expectations(const Parameters& p) {
  const int n = base(p);
  std::vector<Expectation> all;
  const auto expect = [&](int row, int place) {
    const Vec at = on_slope(p, place_of(n, pitch, row, place));
    const auto off = [=](const Stepping& s) { return Off(p, s, row, duration, n * pitch); };
    expect_at(all, p, name_of(row, place), at, off,
              "statics: every contact bears straight against gravity, with a friction of tan a times its load");
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
                     .min = 1.1,
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
}  // namespace held_pyramid
}  // namespace plumb::scenarios
