#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::dry_oscillator {
namespace {

constexpr double gravity = 10;       // m/s^2
constexpr double half_period = 0.5;  // s, so that every turning point is on a frame
constexpr double length = 3;         // m, of the spring
constexpr Vec size{1, 0.5};          // m; too low to tip: mu < b/h = 2
constexpr double w = std::numbers::pi / half_period;

// m, by which friction shifts the middle of a swing: mu m g/k.
double shift(const Parameters& p) { return p.at("friction") * gravity / (w * w); }

// Swings until it sticks: from |x| = a the next turning point is at a - 2 shift on the other side, and it stays where
// |x| <= shift.
int swings(const Parameters& p) {
  return static_cast<int>(std::max(std::ceil((p.at("amplitude") - shift(p)) / (2 * shift(p))), 0.0));
}

double turning_point(const Parameters& p, int n) {
  return (n % 2 == 0 ? 1 : -1) * (p.at("amplitude") - 2 * n * shift(p));
}

Scene scene(const Parameters& p) {
  Scene scene{.name = "dry-oscillator",
              .about = "A block on a spring slides back and forth over rough ground until it sticks.",
              .gravity = {0, -gravity},
              .duration = half_period * (swings(p) + 1)};
  const Surface rough = surface(p.at("friction"), 0);
  scene.bodies.push_back(level_ground(rough));
  scene.bodies.push_back(box("block", {p.at("amplitude"), size.y / 2}, size, rough));
  const double mass = mass_of(scene.bodies[1]).mass;
  scene.forces.push_back(
      Spring{.b = 1, .anchor_a = {-length, size.y / 2}, .stiffness = mass * w * w, .length = length});
  return scene;
}

// x'' = -w^2 x -+ mu g: half swings about -+shift, each of the time pi/w (Den Hartog 1931). Turning points are extremes
// of both x and the energy that symplectic methods keep, so what a method is early or late by counts with its square.
// With k = w f, f the interval of forces, and the amplitude a of the swing:
//   method    its energy is off by a share of k^2/4, its half period by k^2/24 of itself;
//   turning   the step in which the block stops is stopped as a whole: it may lose a step's time and (w^2 a) f^2 of its
//             way;
//   timing    all that, and the half step of first-order methods, makes the n-th turning point at most n + 1 steps
//             late: a (n + 1)^2 k^2/2;
//   start     contact found a lag late; mu times the slop while the block sinks in; its lean by the gap.
std::vector<Expectation> expectations(const Parameters& p) {
  const double mu = p.at("friction");
  const double end = scene(p).duration;
  const int last = swings(p);
  const double amplitude = p.at("amplitude");
  const double reach = length + amplitude * (1 + w * end);
  const auto place = [=, moved = shift(p)](const Stepping& s, int n) {
    const double k = w * force_interval(s);
    double off = 0;
    for (int i = 0; i < n; ++i) {
      const double a = amplitude - (2 * i + 1) * moved;  // m, of this swing
      off += a * (k * k / 4 + k * k) + mu * gravity / (w * w) * k * k;
    }
    const double now = std::max(amplitude - (2 * n - 1) * moved, 0.0);
    const double late = now * (n + 1) * (n + 1) * k * k / 2;
    const double grown = grows(s) ? amplitude * (std::pow(1 + k * k, end / (2 * force_interval(s))) - 1) : 0;
    return off + late + grown + slid_late(s, mu * gravity) + mu * s.slop + size.y / size.x * s.contact_gap() +
           round_off(s, end, reach);
  };
  std::vector<Expectation> all;
  for (int n = 1; n < last; ++n) {
    all.push_back({.body = "block",
                   .quantity = Quantity::x,
                   .time = n * half_period,
                   .expected = turning_point(p, n),
                   .allowed = [=](const Stepping& s) { return place(s, n); },
                   .source = "turns 2 mu m g/k nearer after each half period"});
  }
  all.push_back({.body = "block",
                 .quantity = Quantity::x,
                 .expected = turning_point(p, last),
                 .allowed = [=](const Stepping& s) { return place(s, last) + s.creep * half_period; },
                 .source = "sticks where friction carries the spring's pull; creep"});
  all.push_back(
      {.body = "block",
       .quantity = Quantity::vx,
       .expected = 0,
       .allowed = [=](const Stepping& s) { return s.creep + still_sinking(s, mu, end) + round_off(s, end, reach); },
       .source = "sticks; creep, and what sinks in lets go of mu times its speed"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "dry-oscillator",
     .question = "Does dry friction shorten each half swing of a block on a spring by the same, and then hold it?",
     .parameters = {{.name = "friction", .value = 0.4, .min = 0.2, .max = 1, .about = "of block and ground"},
                    {.name = "amplitude", .value = 1, .min = 0.6, .max = 2, .unit = "m", .about = "at the start"}},
     .variants = {{"mu=0.4", {}}, {"mu=0.9", {{"friction", 0.9}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::dry_oscillator
