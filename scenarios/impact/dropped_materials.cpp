#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/surface.h"

namespace plumb::scenarios::dropped_materials {
namespace {

constexpr double duration = 3;  // s
constexpr double gravity = 10;  // m/s^2
constexpr double radius = 0.3;  // m
constexpr double pitch = 2;     // m, from pad to pad
const Vec pad{1.6, 0.4};        // m

struct DroppedDisc {
  NamedSurface falls, lies;
  double x;
  std::string name() const { return falls.name + " on " + lies.name; }
  double restitution() const { return std::max(falls.surface.restitution, lies.surface.restitution); }
};

// A material without density cannot fall.
std::vector<DroppedDisc> drops() {
  std::vector<DroppedDisc> all;
  for (const NamedSurface& falls : materials()) {
    if (falls.surface.density == 0) continue;
    for (const NamedSurface& lies : materials()) {
      all.push_back({falls, lies, static_cast<double>(all.size()) * pitch});
    }
  }
  return all;
}

// A disc of each material above a fixed pad of each; the tops of the pads are at y = 0.
Scene scene(const Parameters& p) {
  Scene scene{.name = "materials",
              .about = "A disc of every material is dropped on a pad of every material.",
              .gravity = {0, -gravity},
              .duration = duration};
  for (const DroppedDisc& drop : drops()) {
    scene.bodies.push_back(fixed(box("under " + drop.name(), {drop.x, -pad.y / 2}, pad, drop.lies.surface)));
    scene.bodies.push_back(disc(drop.name(), {drop.x, p.at("height") + radius}, radius, drop.falls.surface));
  }
  return scene;
}

// The first apex, e^2 h; sampled every dt, a top is seen up to g dt^2/8 too low.
double allowed_apex(double e, double height, const Stepping& s) {
  const double slack = gravity * s.h * (s.impact_lag + std::abs(s.drift));
  const ReboundError off = rebound_error(s, e, std::sqrt(2 * gravity * height) + slack);
  return std::max(off.low, off.high) + gravity * s.dt * s.dt / 8 + round_off(s, duration, 10 * height);
}

// At rest since sqrt(2h/g) (1+e)/(1-e). The speed that late impacts add, `slack` each, converges to e/(1-e) times it,
// and the disc hops as high and as deep as that speed takes it. Below the threshold nothing hops.
double allowed_rest(double e, double height, const Stepping& s) {
  const double slack = gravity * s.h * (s.impact_lag + std::abs(s.drift));
  const double left = slack / (1 - e);
  return left * left / (2 * gravity) + left * lag(s) + s.contact_gap() + round_off(s, duration, 10 * height);
}

std::vector<Expectation> expectations(const Parameters& p) {
  const double height = p.at("height");
  std::vector<Expectation> all;
  for (const DroppedDisc& drop : drops()) {
    const double e = drop.restitution();
    // Hops of only a few steps have no apex to sample; long ones have not come to rest by the end.
    constexpr double high = 0.5;
    if (e > high) {
      all.push_back({.body = drop.name(),
                     .quantity = Quantity::apex,
                     .index = 1,
                     .expected = radius + e * e * height,
                     .allowed = [=](const Stepping& s) { return allowed_apex(e, height, s); },
                     .source = "e^2 h, e the larger of the two; late detection of the impact, drift, skin"});
    } else {
      all.push_back({.body = drop.name(),
                     .quantity = Quantity::y,
                     .expected = radius,
                     .allowed = [=](const Stepping& s) { return allowed_rest(e, height, s); },
                     .source = "at rest since sqrt(2h/g) (1+e)/(1-e); hops left by late detection"});
    }
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "materials",
     .question = "Does every material bounce off every other with the larger restitution of the two?",
     .parameters = {{.name = "height",
                     .value = 2,
                     .min = 1,
                     .max = 4,
                     .unit = "m",
                     .about = "of the discs' lowest points at the start"}},
     .variants = {{"each on each", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::dropped_materials
