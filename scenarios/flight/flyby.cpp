#include <cmath>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::flyby {
namespace {

constexpr double duration = 4;  // s, from one side of the sun to its mirror image
constexpr double span = 1.5;    // hyperbolic anomaly at the end; its negative at the start
constexpr double turned = 0.5;  // rad, of the line to the nearest point
constexpr Vec sun{0.5, -1};     // m

struct State {
  Vec position, velocity;  // from the sun
};

double eccentricity(const Parameters& p) { return p.at("eccentricity"); }
double axis(const Parameters& p) { return p.at("nearest") / (eccentricity(p) - 1); }  // m, semi-major, > 0

// n t = e sinh F - F, n = sqrt(k/a^3), with the given span in the given time.
double rate(const Parameters& p) { return (eccentricity(p) * std::sinh(span) - span) / (duration / 2); }
double strength(const Parameters& p) { return rate(p) * rate(p) * std::pow(axis(p), 3); }

// r = a (e - cosh F, sqrt(e^2 - 1) sinh F) from the sun, the x axis towards the nearest point (Landau & Lifshitz,
// Mechanics, 15).
State at_anomaly(const Parameters& p, double anomaly) {
  const double e = eccentricity(p);
  const double a = axis(p);
  const double b = a * std::sqrt(e * e - 1);
  const double turning = rate(p) / (e * std::cosh(anomaly) - 1);  // 1/s, dF/dt
  const auto turn = [](double x, double y) {
    return Vec{std::cos(turned) * x - std::sin(turned) * y, std::sin(turned) * x + std::cos(turned) * y};
  };
  return {turn(a * (e - std::cosh(anomaly)), b * std::sinh(anomaly)),
          turn(-a * std::sinh(anomaly) * turning, b * std::cosh(anomaly) * turning)};
}

Scene scene(const Parameters& p) {
  Scene scene{.name = "flyby",
              .about = "A comet that is faster than it would have to be to escape passes a sun.",
              .gravity = {0, 0},
              .duration = duration};
  Body star = fixed(disc("sun", sun, 0.3, {}));
  star.layers = 1;
  const State start = at_anomaly(p, -span);
  Body comet = disc("comet", {sun.x + start.position.x, sun.y + start.position.y}, 0.1, {});
  comet.layers = 2;
  comet.velocity = start.velocity;
  scene.bodies = {star, comet};
  scene.forces.push_back(Attraction{.from = 0, .strength = strength(p)});
  return scene;
}

// One step of the textbook's method that an engine states to be like: explicit or symplectic Euler, in either order, or
// Verlet.
void step(State& state, double strength, double h, const Stepping& s) {
  const auto kick = [&](double time, Vec at) {
    const double r = std::hypot(at.x, at.y);
    state.velocity.x -= strength * at.x / (r * r * r) * time;
    state.velocity.y -= strength * at.y / (r * r * r) * time;
  };
  const auto move = [&](double time) {
    state.position.x += state.velocity.x * time;
    state.position.y += state.velocity.y * time;
  };
  const Vec before = state.position;
  if (s.drift == 0) {
    kick(h / 2, before);
    move(h);
    kick(h / 2, state.position);
  } else if (s.drift > 0) {
    kick(h, before);
    move(h);
  } else {
    move(h);
    kick(h, grows(s) ? before : state.position);
  }
}

// How far that method is from the hyperbola after so many seconds: the larger error of both coordinates is at most
// that. Others of its order differ by their constants, at most twice for second-order methods (Hairer, Lubich, Wanner,
// Geometric Numerical Integration, II.3: -1/24 and 1/12 h^2).
struct Error {
  double place = 0, velocity = 0;
};

Error error_after(const Parameters& p, double time, double anomaly, const Stepping& s) {
  if (s.h == 0) return {};
  const double h = force_interval(s);
  State state = at_anomaly(p, -span);
  for (int i = 0, steps = static_cast<int>(std::lround(time / h)); i < steps; ++i) step(state, strength(p), h, s);
  const State exact = at_anomaly(p, anomaly);
  return {2 * std::hypot(state.position.x - exact.position.x, state.position.y - exact.position.y),
          2 * std::hypot(state.velocity.x - exact.velocity.x, state.velocity.y - exact.velocity.y)};
}

// Nearest after half the time, with the largest speed at right angles to the line to the sun; at the end at the mirror
// image of the start, so that it is deflected by twice the angle between its velocity and the line at right angles.
std::vector<Expectation> expectations(const Parameters& p) {
  const double fastest = std::hypot(at_anomaly(p, 0).velocity.x, at_anomaly(p, 0).velocity.y);
  const State end = at_anomaly(p, span);
  // Round-off grows by what a displacement does: at most (v/q) t at the nearest point q.
  const double grows_by = 1 + fastest / p.at("nearest") * duration;
  const double reach = 2 * (std::hypot(end.position.x, end.position.y) + fastest * duration);
  const auto round = [=](const Stepping& s) { return round_off(s, duration, reach) * grows_by; };
  std::vector<Expectation> all;
  for (const double anomaly : {0.0, span}) {
    const double time = anomaly == 0 ? duration / 2 : duration;
    const State at = at_anomaly(p, anomaly);
    const auto place = [=](const Stepping& s) { return error_after(p, time, anomaly, s).place + round(s); };
    const auto velocity = [=](const Stepping& s) { return error_after(p, time, anomaly, s).velocity + round(s); };
    const std::string where = anomaly == 0 ? "nearest after half the time" : "at the mirror image of the start";
    const auto add = [&](Quantity quantity, double expected, const auto& allowed) {
      all.push_back({.body = "comet",
                     .quantity = quantity,
                     .time = time,
                     .expected = expected,
                     .allowed = allowed,
                     .source = where + ", n t = e sinh F - F; twice the error of the stated method"});
    };
    add(Quantity::x, sun.x + at.position.x, place);
    add(Quantity::y, sun.y + at.position.y, place);
    add(Quantity::vx, at.velocity.x, velocity);
    add(Quantity::vy, at.velocity.y, velocity);
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "flyby",
     .question = "Does a comet pass its sun on a hyperbola, at the right time, and leave in the right direction?",
     .parameters =
         {{.name = "nearest", .value = 1.5, .min = 0.5, .max = 10, .unit = "m", .about = "distance to the sun"},
          {.name = "eccentricity", .value = 1.6, .min = 1.2, .max = 5, .about = "of the hyperbola"}},
     .variants = {{"e=1.6", {}}},
     .scene = scene,
     .expectations = expectations,
     .smoothness = [](const Parameters&) { return Smoothness::free; }}};

}  // namespace
}  // namespace plumb::scenarios::flyby
