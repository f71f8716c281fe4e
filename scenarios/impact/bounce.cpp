#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::bounce {
namespace {

constexpr double gravity = 10;   // m/s^2
constexpr double duration = 10;  // s
constexpr int apexes = 3;
constexpr double shortest = 0.1;  // s, half the shortest flight that samples of 1/60 s resolve

Scene scene(const Parameters& p) {
  const double radius = p.at("radius");
  const Surface bouncy = surface(0, p.at("restitution"));
  Scene scene{
      .name = "bounce", .about = "A disc is dropped on level ground.", .gravity = {0, -gravity}, .duration = duration};
  scene.bodies.push_back(level_ground(bouncy));
  scene.bodies.push_back(disc("disc", {0, p.at("height") + radius}, radius, bouncy));
  return scene;
}

// Lower and upper bounds of the apex in an engine, flight by flight. An impact slower than the threshold may not
// bounce.
struct ApexRange {
  double low = 0, high = 0;  // m, of the apex above the ground
};

ApexRange after_impact(ApexRange before, double e, const Stepping& s) {
  const double slack = gravity * s.h * (s.impact_lag + std::abs(s.drift));  // m/s, error of the speed itself
  const double fastest = std::sqrt(2 * gravity * before.high) + slack;
  const double slowest = std::sqrt(2 * gravity * std::max(before.low, 0.0)) - slack;
  const ReboundError off = rebound_error(s, e, fastest);
  const bool sure = slowest > s.restitution_threshold;
  return {sure ? e * e * before.low - off.low : -fastest * lag(s) - s.contact_gap(), e * e * before.high + off.high};
}

ApexRange apex_range(int n, double height, double e, const Stepping& s) {
  ApexRange now{height, height};
  for (int k = 0; k < n; ++k) now = after_impact(now, e, s);
  return now;
}

// Apex n, the vertex of the parabola through the samples. A method of drift D moves by v0 t - g t^2/2 - D g h t, whose
// vertex is D^2 g h^2/2 from where its speed would take it.
double allowed_apex(int n, double height, double e, const Stepping& s) {
  const double expected = std::pow(e, 2 * n) * height;
  const ApexRange now = apex_range(n, height, e, s);
  const double time = (2 * n + 1) * std::sqrt(2 * height / gravity);
  return std::max(now.high - expected, expected - now.low) + gravity * s.drift * s.drift * s.h * s.h / 2 +
         round_off(s, time, height + gravity * time * time);
}

// Landing n, where the flights before and after the lowest sample meet, which is exact but for the drift: its positions
// advance by D g h less than its speeds say, over 2 dt, and the flights close at the speed V of the fall at least. It
// is never off by more than the samples beside it. Each landing may come a lag late, be half a step off by the drift,
// and be found a skin early, at the speed of its fall. Each flight lasts 2 sqrt(2 H/g), with the H that the impacts
// lead to.
double allowed_landing(int n, double height, double e, const Stepping& s) {
  const double fall = std::sqrt(2 * height / gravity);
  const auto off = [&](double apex) {
    const double v = std::sqrt(2 * gravity * std::max(apex, s.skin));
    return lag(s) + std::abs(s.drift) * s.h + (v > 0 ? s.skin / v : 0);
  };
  const double each = off(height);
  double late = each;
  double early = each;
  ApexRange now{height, height};
  for (int k = 1; k < n; ++k) {
    now = after_impact(now, e, s);
    const double exact = 2 * std::pow(e, k) * fall;
    late += 2 * std::sqrt(2 * now.high / gravity) - exact + off(now.low);
    early += exact - 2 * std::sqrt(2 * std::max(now.low, 0.0) / gravity) + off(now.low);
  }
  const double speed = std::sqrt(2 * gravity * std::max(now.low, 0.0));
  const double bent = 2 * std::abs(s.drift) * gravity * s.h * s.dt;  // m
  const double sampled = speed * s.dt > bent ? bent / speed : s.dt;
  return std::max(late, early) + sampled + round_off(s, 2 * n * fall, 2 * n * fall);
}

// At the end the disc is at rest; an engine may still be in the latest flight that its longest possible flights leave
// time for.
double allowed_rest(double height, double e, const Stepping& s) {
  constexpr double settled = 1e-15;  // m
  ApexRange now{height, height};
  double time = std::sqrt(2 * height / gravity) + s.h;
  while (time < duration && now.high > settled) {
    const double before = now.high;
    now = after_impact(now, e, s);
    time += 2 * std::sqrt(2 * now.high / gravity) + s.h;
    if (now.high > before) return std::numeric_limits<double>::infinity();  // with so coarse a step it never settles
  }
  return std::max(now.high, -now.low) + s.contact_gap() +
         round_off(s, duration, height + gravity * duration * duration);
}

// For e = 1 the energy is m g times the apex, except for the drift's m g D h |v| within a flight. The first impact is
// at sqrt(2h/g) and the others are twice that apart; there may have been one more than that by the end. What it may
// have lost, or gained.
double allowed_energy(double weight, double height, Relation relation, const Stepping& s) {
  const int impacts = static_cast<int>(std::ceil(duration / (2 * std::sqrt(2 * height / gravity)) + 0.5));
  const ApexRange last = apex_range(impacts, height, 1, s);
  const double fastest = std::sqrt(2 * gravity * last.high);
  const double apex = relation == Relation::at_most ? last.high - height : height - last.low;
  return weight * (apex + std::abs(s.drift) * s.h * fastest) +
         weight * round_off(s, duration, height + gravity * duration * duration);
}

// How many flights after an impact the samples resolve; an apex needs its own, and a landing the one that follows it.
int flights_seen(double fall, double e) {
  int n = 0;
  while (n < apexes && std::pow(e, n + 1) * fall >= shortest) ++n;
  return n;
}

// Read by linear interpolation, which is off by g dt^2/8.
double allowed_fall(double time, double height, const Stepping& s) {
  return drifted(s, gravity, time) + gravity * s.dt * s.dt / 8 + round_off(s, time, height + gravity * time * time);
}

std::vector<Expectation> expectations(const Parameters& p) {
  const double height = p.at("height");
  const double e = p.at("restitution");
  const double radius = p.at("radius");
  const double fall = std::sqrt(2 * height / gravity);
  const int seen = flights_seen(fall, e);
  std::vector<Expectation> all;
  for (int n = 1; n <= seen; ++n) {
    all.push_back({.body = "disc",
                   .quantity = Quantity::apex,
                   .index = n,
                   .expected = radius + std::pow(e, 2 * n) * height,
                   .allowed = [=](const Stepping& s) { return allowed_apex(n, height, e, s); },
                   .source = "e^(2n) h; late detection of impacts, drift, skin"});
  }
  if (seen == 0) {
    all.push_back({.body = "disc",
                   .quantity = Quantity::y,
                   .time = fall / 2,
                   .expected = radius + height * 3 / 4,
                   .allowed = [=](const Stepping& s) { return allowed_fall(fall / 2, height, s); },
                   .source = "h - g t^2/2; drift, one interpolation"});
  }
  double landed = fall;
  for (int n = 1; n <= seen && landed < duration; ++n) {
    all.push_back({.body = "disc",
                   .quantity = Quantity::landing,
                   .index = n,
                   .expected = landed,
                   .allowed = [=](const Stepping& s) { return allowed_landing(n, height, e, s); },
                   .source = "sqrt(2h/g) (1 + 2 sum e^k); late detection of impacts, drift, skin"});
    landed += 2 * std::pow(e, n) * fall;
  }
  const double last_impact = std::sqrt(2 * height / gravity) * (1 + e) / (1 - e);
  if (e < 1 && last_impact < duration) {
    all.push_back({.body = "disc",
                   .quantity = Quantity::y,
                   .allowed = [=](const Stepping& s) { return allowed_rest(height, e, s); },
                   .source = "at rest since sqrt(2h/g) (1+e)/(1-e); hops left by late detection"});
  }
  if (e == 1) {
    const double weight = mass_of(scene(p).bodies[1]).mass * gravity;
    for (const Relation relation : {Relation::at_least, Relation::at_most}) {
      all.push_back({.quantity = Quantity::energy,
                     .relation = relation,
                     .allowed = [=](const Stepping& s) { return allowed_energy(weight, height, relation, s); },
                     .source = "constant, as e = 1; late detection of impacts, drift, skin"});
    }
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "bounce",
     .question = "Does a dropped disc bounce as high as its restitution says and come to rest at the right time?",
     .parameters = {{.name = "restitution", .value = 0.8, .min = 0, .max = 1, .about = "of disc and ground"},
                    {.name = "height",
                     .value = 4,
                     .min = 0.1,
                     .max = 20,
                     .unit = "m",
                     .about = "of the disc's lowest point at the start"},
                    {.name = "radius", .value = 0.5, .min = 0.05, .max = 2, .unit = "m", .about = "of the disc"}},
     .variants = {{"e=0.5", {{"restitution", 0.5}}}, {"e=0.8", {}}, {"e=1", {{"restitution", 1}}}},
     .closed_form = "bounce",
     .scene = scene,
     .expectations = expectations,
     .canonical = true,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::bounce
