#include "reports/study/statistics/ensembles/domino_model.h"

#include <algorithm>
#include <cmath>
#include <vector>

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
  double time = 0;
  for (int impact = 0; impact < impacts; ++impact) {
    const int count = std::min(impact + 1, pushing);
    const Train upright(*this, count, 0);
    const double energy = start * start / 2 * upright.squares() + potential(*this, upright);
    const auto rate = [&](double angle) {
      const Train train(*this, count, angle);
      return std::sqrt(2 * (energy - potential(*this, train)) / train.squares());
    };
    time = 0;
    for (int i = 0; i < intervals; ++i) time += end / intervals / rate((i + 0.5) * end / intervals);
    const Train before(*this, count, end);
    const Train after(*this, count + 1, 0);
    double momentum = 0;
    for (std::size_t i = 0; i < before.ratios.size(); ++i) momentum += before.ratios[i] * after.ratios[i + 1];
    start = rate(end) * momentum / after.squares();
  }
  return pitch / time;
}

}  // namespace plumb::ensembles
