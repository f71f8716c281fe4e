#include "reports/study/statistics/ensembles/models.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenarios/integrate.h"
#include "scenarios/random.h"
#include "scenarios/scene/scene.h"

namespace plumb::ensembles {
namespace {

// The dominoes from the front one back, when that leans by `angle`: their angles, and the ratios of their angular
// velocities to the front one's. The corner of one leans on the back of the next: h sin(lean - next) = p cos(next) - d.
struct Train {
  std::vector<double> angles, ratios;

  Train(const DominoRow& row, int count, double angle) {
    double ratio = 1;
    for (int i = 0; i < count; ++i) {
      angles.push_back(angle);
      ratios.push_back(ratio);
      const double more = std::asin((row.pitch * std::cos(angle) - row.thickness) / row.height);
      ratio *= 1 - row.pitch * std::sin(angle) / (row.height * std::cos(more));
      angle += more;
    }
  }

  double squares() const {
    double sum = 0;
    for (const double ratio : ratios) sum += ratio * ratio;
    return sum;
  }
};

// Over the moment of inertia about the foot, m (h^2 + d^2)/3.
double potential(const DominoRow& row, double angle) {
  const double h = row.height;
  const double d = row.thickness;
  return 1.5 * standard_gravity * (h * std::cos(angle) + d * std::sin(angle)) / (h * h + d * d);
}

double potential(const DominoRow& row, const Train& train) {
  double sum = 0;
  for (const double angle : train.angles) sum += potential(row, angle);
  return sum;
}

constexpr int intervals = 400;  // of the angle up to the next impact, by the midpoint rule

}  // namespace

double DominoRow::strikes_at() const { return std::asin((pitch - thickness) / height); }

// One degree of freedom between impacts, with constant energy. An impact adds the next domino, at rest: with ideal
// constraints the momentum along the new motion is kept, w' = w sum(r_i r'_i)/sum(r'_i^2). Then the last one stays
// behind.
double DominoRow::speed(int pushing) const {
  constexpr int impacts = 60;  // after which the start is forgotten
  const double end = strikes_at();
  double start = 1;  // rad/s
  for (int impact = 1;; ++impact) {
    const int count = std::min(impact, pushing);
    const Train upright(*this, count, 0);
    const double energy = start * start / 2 * upright.squares() + potential(*this, upright);
    const auto rate = [&](double angle) {
      const Train train(*this, count, angle);
      return std::sqrt(2 * (energy - potential(*this, train)) / train.squares());
    };
    if (impact == impacts) {
      double time = 0;
      for (int i = 0; i < intervals; ++i) time += end / intervals / rate((i + 0.5) * end / intervals);
      return pitch / time;
    }
    const Train before(*this, count, end);
    const Train after(*this, count + 1, 0);
    double momentum = 0;
    for (std::size_t i = 0; i < before.ratios.size(); ++i) momentum += before.ratios[i] * after.ratios[i + 1];
    start = rate(end) * momentum / after.squares();
  }
}

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
