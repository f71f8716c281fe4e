#include "reports/study/statistics/ensembles/double_pendulum.h"

#include <cmath>

#include "scenarios/integrate.h"
#include "scenarios/random.h"
#include "scenarios/scene/scene.h"

namespace plumb::ensembles {
namespace {

constexpr double gravity = standard_gravity;
constexpr double step = 1e-3;  // s
constexpr double l = DoublePendulum::length;
// Per kg of a rod.
constexpr double own =
    (l * l + DoublePendulum::thickness * DoublePendulum::thickness) / 12 + l * l / 4;  // about its end
constexpr double coupling = l * l / 2;

}  // namespace

DoublePendulum::State DoublePendulum::derivative(const State& s) {
  const auto [a, b, u, v] = s;
  const double cosine = coupling * std::cos(a - b);
  const double sine = coupling * std::sin(a - b);
  const double first = own + l * l;
  const double on_first = -sine * v * v - 1.5 * gravity * l * std::sin(a);
  const double on_second = sine * u * u - 0.5 * gravity * l * std::sin(b);
  const double determinant = first * own - cosine * cosine;
  return {u, v, (own * on_first - cosine * on_second) / determinant,
          (first * on_second - cosine * on_first) / determinant};
}

double DoublePendulum::energy(const State& s) {
  const auto [a, b, u, v] = s;
  const double moving = (own + l * l) / 2 * u * u + own / 2 * v * v + coupling * std::cos(a - b) * u * v;
  return moving + gravity * l * (1.5 * (1 - std::cos(a)) + 0.5 * (1 - std::cos(b)));
}

DoublePendulum::State DoublePendulum::after(const State& s, double time) {
  return integrated(s, time, static_cast<int>(std::ceil(time / step)), derivative);
}

DoublePendulum::State DoublePendulum::drawn(std::uint64_t seed) {
  Random random(seed);
  constexpr double angle = 2.2;   // rad
  constexpr double spread = 0.1;  // rad
  // The second rod makes up in speed for what the first has less of height, so that all have one energy.
  State start{angle - random.between(0, spread), angle, 0, 0};
  start[3] = std::sqrt(2 * (energy({angle, angle, 0, 0}) - energy(start)) / own);
  return after(start, random.between(10, 20));
}

double distance(const DoublePendulum::State& p, const DoublePendulum::State& q) {
  double squares = 0;
  for (std::size_t i = 0; i < 4; ++i) squares += (p[i] - q[i]) * (p[i] - q[i]) / (i < 2 ? 1 : gravity / l);
  return std::sqrt(squares);
}

}  // namespace plumb::ensembles
