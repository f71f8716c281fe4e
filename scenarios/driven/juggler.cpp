#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/scene.h"

namespace plumb::scenarios::juggler {
namespace {

constexpr double gravity = 10;   // m/s^2
constexpr double radius = 0.25;  // m
constexpr Vec size{6, 1};        // m, of the table
constexpr double shift = 0.007;  // s, from a period's half to the first impact, which so is between two steps
constexpr double asked = 0.1;    // of a period, from each impact to the readings

// The orbit that hits once a period T, always at the same phase of the table (Holmes, J. Sound Vib. 84, 1982). The ball
// leaves at u = g T/2 and returns at -u; u - V = e (u + V) tells the table's velocity V at the impact. It is an
// attractor where the table is slowed down by less than 2 g (1 + e^2)/(1 + e)^2 then; `share` is its share of that.
// From 1 on each bounce is the farther off it, early and late by turns, towards two bounces in two periods.
struct Orbit {
  int impacts;
  double e, period, u, velocity, slowing, w, phase;

  explicit Orbit(const Parameters& p)
      : impacts(static_cast<int>(p.at("impacts"))),
        e(p.at("restitution")),
        period(p.at("period")),
        u(gravity * period / 2),
        velocity(u * (1 - e) / (1 + e)),
        slowing(p.at("share") * 2 * gravity * (1 + e * e) / ((1 + e) * (1 + e))),
        w(2 * std::numbers::pi / period),
        phase(std::atan2(slowing / w, velocity)) {}

  double first() const { return period / 2 + shift; }  // s, the time of the first impact
  double reading(int impact) const { return first() + (impact - 1 + asked) * period; }
  Path path() const { return {{0, std::hypot(slowing / w, velocity) / w}, 1 / period, phase - w * first()}; }
  // m, of the table's upper side: 0 at the impacts.
  double top(double t) const { return path_offset(path(), t).y - path_offset(path(), first()).y; }
  double top_velocity(double t) const { return w * path().amplitude.y * std::cos(w * t + path().phase); }
};

struct Flight {
  double from;              // s
  double height, velocity;  // m, m/s, then
  double at(double t) const { return height + (t - from) * (velocity - gravity * (t - from) / 2); }
  double velocity_at(double t) const { return velocity - gravity * (t - from); }
};

// The flight at a time t: between impacts a parabola, the impact where it next meets the table, and e there.
Flight flight(const Parameters& p, double t) {
  const Orbit orbit(p);
  const double height = orbit.u * orbit.u / (2 * gravity) - gravity * shift * shift / 2;
  Flight now{0, height + p.at("off"), gravity * shift};
  const double stride = orbit.period / 200;
  for (double next = stride; next < t; next += stride) {
    const auto above = [&](double at) { return now.at(at) > orbit.top(at); };
    if (next - now.from < 2 * stride || above(next)) continue;
    double low = next - stride;
    double high = next;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (above(middle) ? low : high) = middle;
    }
    if (low > t) break;
    const double table = orbit.top_velocity(low);
    now = {low, orbit.top(low), table + orbit.e * (table - now.velocity_at(low))};
  }
  return now;
}

Scene scene(const Parameters& p) {
  const Orbit orbit(p);
  const Surface of = surface(0, orbit.e);
  Scene scene{.name = "juggler",
              .about = "A ball bounces on a table that moves up and down, once a period.",
              .gravity = {0, -gravity},
              .duration = whole_steps(orbit.reading(orbit.impacts))};
  Body table = box("table", {0, orbit.top(0) - size.y / 2}, size, of);
  table.type = BodyType::kinematic;
  table.path = orbit.path();
  const Flight start = flight(p, 0);
  Body ball = disc("ball", {0, start.height + radius}, radius, of);
  ball.velocity = {0, start.velocity};
  scene.bodies = {table, ball};
  return scene;
}

// What errors of one impact, in time and in the velocity after it, are in all of the n impacts up to a time: the powers
// of the map's derivative at the orbit, ((1, (1+e)/g), (-(1+e) a, e^2 - (1+e)^2 a/g)), with their signs dropped.
struct Errors {
  double time, velocity;  // s, m/s
};

Errors gathered(const Orbit& orbit, Errors each, int count) {
  const double e = orbit.e;
  const double m[2][2] = {{1, (1 + e) / gravity},
                          {-(1 + e) * orbit.slowing, e * e - (1 + e) * (1 + e) * orbit.slowing / gravity}};
  double power[2][2] = {{1, 0}, {0, 1}};
  Errors sum{0, 0};
  for (int n = 0; n < count; ++n) {
    sum.time += std::abs(power[0][0]) * each.time + std::abs(power[0][1]) * each.velocity;
    sum.velocity += std::abs(power[1][0]) * each.time + std::abs(power[1][1]) * each.velocity;
    double next[2][2];
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) next[i][j] = m[i][0] * power[0][j] + m[i][1] * power[1][j];
    }
    std::copy(&next[0][0], &next[0][0] + 4, &power[0][0]);
  }
  return sum;
}

// Off the orbit by `off` the first impact is late by l = off/(u + V), and the table's acceleration changes by w^2 V l.
//   table   it moves at its mean velocity over a step, (a + w^2 V l) dt/2 off at the ends of the step, and later by the
//           lag of an impact; the velocity after that by (1 + e) times that;
//   found   late by the lag or early by the skin, by which the way up begins later and lower: both again at the next
//           impact; also by the height of the arc over the chord on which the table moves, A w^2 dt^2/8; e g times
//           that in the velocity;
//   drift   |drift| g T h of the height: over the closing speed (1 + e)^-1 2 u, |drift| (1 + e) h of the time.
// The map's own bend is the share w times the error in time.
std::vector<Expectation> expectations(const Parameters& p) {
  const Orbit orbit(p);
  const double closing = orbit.u + orbit.velocity;
  const double bend = orbit.slowing + orbit.w * orbit.w * orbit.velocity * std::abs(p.at("off")) / closing;
  const double amplitude = orbit.path().amplitude.y;
  const double end = orbit.reading(orbit.impacts);
  const auto exact = [=](const Stepping& s) {
    return round_off(s, end, 2 * (closing + amplitude * orbit.w) * (1 + end));
  };
  const auto errors = [=](const Stepping& s, int count) {
    const double chord = amplitude * orbit.w * orbit.w * s.dt * s.dt / (8 * closing);
    const double found = 2 * found_off(s, closing) + std::abs(s.drift) * (1 + orbit.e) * s.h + chord;
    const double velocity = (1 + orbit.e) * bend * (s.dt / 2 + lag(s)) + orbit.e * gravity * found;
    const Errors all = gathered(orbit, {found, velocity}, count);
    const double share = 1 + orbit.w * all.time;
    return Errors{share * all.time, share * all.velocity};
  };
  std::vector<Expectation> all;
  const double late = asked * orbit.period;  // s, after an impact
  for (const int count : std::set{1, orbit.impacts}) {
    const double t = orbit.reading(count);
    const Flight now = flight(p, t);
    all.push_back({.body = "ball",
                   .quantity = Quantity::y,
                   .time = t,
                   .expected = now.at(t) + radius,
                   .allowed =
                       [=](const Stepping& s) {
                         const Errors off = errors(s, count);
                         return (closing - gravity * late) * off.time + late * off.velocity + s.contact_gap() +
                                drifted(s, gravity, late) + gravity * s.dt * s.dt / 8 + exact(s);
                       },
                   .source = "the map of impacts; the table's velocity within a step, the lag and the drift"});
    all.push_back({.body = "ball",
                   .quantity = Quantity::vy,
                   .time = t,
                   .expected = now.velocity_at(t),
                   .allowed =
                       [=](const Stepping& s) {
                         const Errors off = errors(s, count);
                         return off.velocity + gravity * off.time + exact(s);
                       },
                   .source = "the map of impacts; the table's velocity within a step, the lag and the drift"});
  }
  for (const double t : {0.3 * end, end}) {
    all.push_back(
        {.body = "table",
         .quantity = Quantity::y,
         .time = t,
         .expected = orbit.top(t) - size.y / 2,
         .allowed = [=](const Stepping& s) { return amplitude * orbit.w * orbit.w * s.dt * s.dt / 8 + exact(s); },
         .source = "its path, at each step's end; a chord between two"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "juggler",
     .question = "Does a ball settle to one bounce a period on a table that moves up and down, if that is stable?",
     .parameters =
         {{.name = "restitution", .value = 0.5, .min = 0.3, .max = 0.7, .about = "of ball and table"},
          {.name = "period", .value = 2, .min = 1.5, .max = 5, .unit = "s", .about = "of the table and the ball"},
          {.name = "share",
           .value = 0.1,
           .min = 0.05,
           .max = 1.1,
           .about = "of the largest slowing at the impact at which the bounce is stable"},
          {.name = "off",
           .value = 0,
           .min = -0.3,
           .max = 0.3,
           .unit = "m",
           .about = "of the orbit's height at the start"},
          {.name = "impacts", .value = 5, .min = 1, .max = 5, .about = "until the end", .whole = true}},
     .variants = {{"orbit", {}},
                  {"settles", {{"off", 0.3}}},
                  {"e=0.7", {{"restitution", 0.7}, {"off", -0.2}}},
                  {"unstable", {{"share", 1.1}, {"off", 0.1}, {"period", 5}, {"impacts", 2}}}},
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::juggler
