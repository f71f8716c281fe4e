#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::head_on {
namespace {

constexpr double duration = 2;  // s
constexpr double radius = 0.5;  // m
constexpr double apart = 2.03;  // m between the rims, so that no impact falls on a step

Scene scene(const Parameters& p) {
  const double e = p.at("restitution");
  Scene scene{.name = "head-on", .about = "Two discs meet head-on.", .gravity = {0, 0}, .duration = duration};
  scene.bodies.push_back(disc("left", {-radius - apart / 2, 0}, radius, surface(0, e)));
  scene.bodies.push_back(disc("right", {radius + apart / 2, 0}, radius, surface(0, e, p.at("ratio"))));
  scene.bodies[0].velocity = {p.at("left"), 0};
  scene.bodies[1].velocity = {-p.at("right"), 0};
  return scene;
}

// Speeds do not care when the impact is noticed; places are off by the jump, at most (1+e) times the approach, times
// the lag, and by the depth, approach times lag, that may be put right.
std::vector<Expectation> expectations(const Parameters& p) {
  const double approach = p.at("left") + p.at("right");
  const double e = p.at("restitution");
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, apart + 2 * approach * duration); };
  const auto place = [=](const Stepping& s) { return (2 + e) * approach * lag(s) + s.gap + exact(s); };
  std::vector<Expectation> all;
  for (const char* body : {"left", "right"}) {
    all.push_back(
        {.body = body, .quantity = Quantity::vx, .allowed = exact, .source = "((m1 - e m2) v1 + (1+e) m2 v2)/(m1+m2)"});
    all.push_back(
        {.body = body, .quantity = Quantity::x, .allowed = place, .source = "the jump times the lag, and the depth"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "head-on",
     .question = "Do two discs share momentum as their masses and restitution say?",
     .parameters =
         {{.name = "ratio", .value = 3, .min = 0.001, .max = 1000, .about = "mass of the right to the left disc"},
          {.name = "left",
           .value = 3,
           .min = 1,
           .max = 50,
           .unit = "m/s",
           .about = "speed of the left disc, to the right"},
          {.name = "right",
           .value = 1,
           .min = 0,
           .max = 50,
           .unit = "m/s",
           .about = "speed of the right disc, to the left"},
          {.name = "restitution", .value = 0.5, .min = 0, .max = 1, .about = "of both"}},
     .variants = {{"e=0.5", {}}, {"e=1", {{"restitution", 1}}}, {"e=0", {{"restitution", 0}}}},
     .closed_form = "line",
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::head_on
