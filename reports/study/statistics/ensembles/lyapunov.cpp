// How fast two double pendulums that start almost alike part: the largest Lyapunov exponent (Shinbrot, Grebogi, Wisdom,
// Yorke, Am. J. Phys. 60, 1992).

#include <cmath>
#include <numbers>

#include "reports/study/statistics/ensemble.h"
#include "reports/study/statistics/ensembles/models.h"
#include "scenarios/parts.h"
#include "scenarios/random.h"

namespace plumb::ensembles::lyapunov {
namespace {

using State = DoublePendulum::State;

constexpr int pairs = 8;        // in a scene
constexpr double apart = 1e-4;  // rad, a pair at the start: a thousand times the rounding of single precision
constexpr double from = 1;      // s, when a pair has turned to the direction that grows
constexpr double to = 2.5;      // s, when it is still close

void add_rod(Scene& scene, Vec hinge, double angle, Vec hinge_velocity, double rate, std::size_t to_body) {
  const double half = DoublePendulum::length / 2;
  const Vec along{std::sin(angle), -std::cos(angle)};
  Body rod = box("rod " + std::to_string(scene.bodies.size()), {hinge.x + half * along.x, hinge.y + half * along.y},
                 {DoublePendulum::length, DoublePendulum::thickness}, {});
  rod.angle = angle - std::numbers::pi / 2;
  rod.angular_velocity = rate;
  rod.velocity = {hinge_velocity.x - half * along.y * rate, hinge_velocity.y + half * along.x * rate};
  rod.layers = 0;
  scene.joints.push_back(Revolute{.a = to_body, .b = scene.bodies.size(), .anchor = hinge});
  scene.bodies.push_back(rod);
}

void add_pendulum(Scene& scene, const State& s) {
  const auto [a, b, u, v] = s;
  const double l = DoublePendulum::length;
  const std::size_t first = scene.bodies.size();
  add_rod(scene, {}, a, {}, u, 0);
  add_rod(scene, {l * std::sin(a), -l * std::cos(a)}, b, {l * std::cos(a) * u, l * std::sin(a) * u}, v, first);
}

State state_of(std::span<const BodyState> states, std::size_t pendulum) {
  const BodyState& first = states[1 + 2 * pendulum];
  const BodyState& second = states[2 + 2 * pendulum];
  return {first.angle, second.angle, first.angular_velocity, second.angular_velocity};
}

double exponent(double early, double late) { return std::log(late / early) / (to - from); }

double by_runge_kutta(const State& p, const State& q) {
  const State early_p = DoublePendulum::after(p, from);
  const State early_q = DoublePendulum::after(q, from);
  return exponent(distance(early_p, early_q),
                  distance(DoublePendulum::after(early_p, to - from), DoublePendulum::after(early_q, to - from)));
}

std::vector<EnsembleDraw> draws(EnsembleRun& run, std::uint64_t seed) {
  Random random(seed);
  Scene scene{.name = "lyapunov", .about = "Pairs of double pendulums that start almost alike.", .duration = to};
  scene.bodies.push_back({.name = "pivot", .type = BodyType::fixed, .layers = 0});
  std::vector<double> expected, early(pairs), late(pairs);
  for (int i = 0; i < pairs; ++i) {
    const State p = DoublePendulum::drawn(random.next());
    const double direction = random.between(0, 2 * std::numbers::pi);
    State q = p;
    q[0] += apart * std::cos(direction);
    q[1] += apart * std::sin(direction);
    add_pendulum(scene, p);
    add_pendulum(scene, q);
    expected.push_back(by_runge_kutta(p, q));
  }
  const double half_step = run.dt() / 2;
  run.watch(scene, [&](double time, std::span<const BodyState> states) {
    for (std::size_t i = 0; i < pairs; ++i) {
      const double now = distance(state_of(states, 2 * i), state_of(states, 2 * i + 1));
      if (time < from + half_step) early[i] = now;
      late[i] = now;
    }
    return true;
  });
  std::vector<EnsembleDraw> found;
  for (std::size_t i = 0; i < pairs; ++i) {
    const double measured = exponent(early[i], late[i]);
    found.push_back({measured, measured - expected[i]});
  }
  return found;
}

const Catalog<Ensemble>::Entry entry{
    {.name = "lyapunov",
     .question = "Do double pendulums that start almost alike part as fast as mechanics says?",
     .dt = 1.0 / 240,
     .runs = 32,
     .large = 640,
     .statistics = {{.name = "exponent",
                     .unit = "1/s",
                     .low = 1.4,
                     .high = 1.52,
                     .resolution = 0.3,
                     .source = "1.46 +- .03: six motions of 1000 s, integrated by Runge and Kutta's method"},
                    {.name = "exponent - Runge-Kutta's",
                     .unit = "1/s",
                     .resolution = 0.3,
                     .source = "the same starts, integrated by Runge and Kutta's method in steps of 1 ms"}},
     .draws = draws,
     .control = [] { return *Catalog<Control>::find("half-gravity"); }}};

}  // namespace
}  // namespace plumb::ensembles::lyapunov
