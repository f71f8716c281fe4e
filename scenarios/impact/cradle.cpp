#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::cradle {
namespace {

constexpr double duration = 2;   // s
constexpr double radius = 0.5;   // m
constexpr double run_up = 0.53;  // m, before the first impact

std::string ball(int i) { return "ball " + std::to_string(i); }

Scene scene(const Parameters& p) {
  Scene scene{
      .name = "cradle", .about = "One disc runs into a row of equal ones.", .gravity = {0, 0}, .duration = duration};
  const int balls = static_cast<int>(p.at("balls"));
  for (int i = 1; i <= balls; ++i) {
    const double x = (i - 1) * (2 * radius + p.at("gap")) - (i == 1 ? run_up : 0);
    scene.bodies.push_back(disc(ball(i), {x, 0}, radius, surface(0, 1)));
  }
  scene.bodies.front().velocity = {p.at("speed"), 0};
  return scene;
}

// Equal masses with e = 1 swap speeds: one after the other, however late each is noticed, and only the last one leaves.
// Ball i is late by the i - 1 impacts before it, and each may have put right the depth it sank in.
std::vector<Expectation> expectations(const Parameters& p) {
  const int balls = static_cast<int>(p.at("balls"));
  const double v = p.at("speed");
  std::vector<Expectation> all;
  for (int i = 1; i <= balls; ++i) {
    const auto exact = [=](const Stepping& s) { return round_off(s, duration, 2 * balls * radius + v * duration); };
    const auto place = [=](const Stepping& s) { return i * (2 * v * lag(s) + s.gap) + exact(s); };
    all.push_back({.body = ball(i), .quantity = Quantity::vx, .allowed = exact, .source = "speeds are handed on"});
    all.push_back(
        {.body = ball(i), .quantity = Quantity::x, .allowed = place, .source = "handed on; a lag late each time"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "cradle",
     .question = "Does a row of balls hand on its speed so that only the last one leaves?",
     .parameters = {{.name = "balls",
                     .value = 5,
                     .min = 2,
                     .max = 20,
                     .about = "in the row, with the one that runs in",
                     .whole = true},
                    {.name = "gap",
                     .value = 0.05,
                     .min = 1e-3,
                     .max = 1,
                     .unit = "m",
                     .about = "between two, so that two meet at a time"},
                    {.name = "speed", .value = 2, .min = 1.5, .max = 20, .unit = "m/s", .about = "of the first"}},
     .variants = {{"five", {}}},
     .closed_form = "line",
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::cradle
