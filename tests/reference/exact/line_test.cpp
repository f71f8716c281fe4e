#include "reference/exact/line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace plumb::line_test {
namespace {

using Particles = std::vector<Line::Particle>;

Particles at(const Line& line, double t, std::size_t count) {
  Particles now(count);
  line.at(t, now);
  return now;
}

TEST(Line, HeadOnSharesMomentumByMassAndRestitution) {
  const double m1 = 2, m2 = 3, v1 = 4, v2 = -1, e = 0.6;
  const Line line({{0, v1, m1, 0.5}, {3, v2, m2, 0.5}}, {}, {0, e, 0}, 10);
  const Particles now = at(line, 5, 2);
  EXPECT_DOUBLE_EQ(now[0].speed, ((m1 - e * m2) * v1 + (1 + e) * m2 * v2) / (m1 + m2));
  EXPECT_DOUBLE_EQ(now[1].speed, ((m2 - e * m1) * v2 + (1 + e) * m1 * v1) / (m1 + m2));
  EXPECT_DOUBLE_EQ(now[0].position, 0.4 * v1 + 4.6 * now[0].speed);  // they meet after 2/5 s
}

TEST(Line, CradlePassesTheSpeedToTheLastBall) {
  Particles row;
  for (int i = 0; i < 6; ++i) row.push_back({1.1 * i, i == 0 ? 2.0 : 0.0, 1, 0.5});
  const Line line(row, {}, std::vector<double>(7, 1), 10);
  const Particles now = at(line, 9, 6);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(now[i].speed, 0);
  EXPECT_EQ(now[5].speed, 2);
  EXPECT_EQ(line.impacts(9), 5u);
}

TEST(Line, CountsTheDigitsOfPi) {
  const std::size_t digits[] = {3, 31, 314, 3141};
  for (int n = 0; n <= 3; ++n) {
    const Line line({{2.5, 0, 1, 0.5}, {6, -2, std::pow(100, n), 0.5}}, {.left = 0}, {1, 1, 0}, 100);
    EXPECT_EQ(line.impacts(100), digits[n]);
  }
}

TEST(Line, ElasticImpactsKeepEnergyAndNeverOverlap) {
  const Line line({{1, 3, 1, 0.2}, {2, -1, 2.5, 0.3}, {4, 0.7, 0.3, 0.1}}, {.left = 0, .right = 5}, {1, 1, 1, 1}, 50);
  EXPECT_GT(line.impacts(50), 50u);
  const auto energy = [](const Particles& p) {
    double sum = 0;
    for (const Line::Particle& one : p) sum += one.mass * one.speed * one.speed / 2;
    return sum;
  };
  for (double t = 0; t < 50; t += 0.37) {
    const Particles now = at(line, t, 3);
    EXPECT_NEAR(energy(now), energy(at(line, 0, 3)), 1e-12);
    EXPECT_GE(now[0].position - now[0].half, -1e-12);
    EXPECT_LE(now[2].position + now[2].half, 5 + 1e-12);
    for (std::size_t i = 1; i < 3; ++i) {
      EXPECT_GE(now[i].position - now[i].half, now[i - 1].position + now[i - 1].half - 1e-12);
    }
  }
}

TEST(Line, EndsWhereThreeWouldMeetAtOnce) {
  const Line line({{0, 1, 1, 0.5}, {2, 0, 1, 0.5}, {4, -1, 1, 0.5}}, {}, {0, 1, 1, 0}, 10);
  EXPECT_DOUBLE_EQ(line.valid_until(), 1);
}

TEST(Line, EndsWhereImpactsAccumulate) {
  // Three equal masses collapse for e < 7 - 4 sqrt 3 = 0.072 (Bernu & Mazighi, 1990).
  const Line line({{0, 1, 1, 0.1}, {1, 0, 1, 0.1}, {2.1, -1, 1, 0.1}}, {}, {0, 0.03, 0.03, 0}, 100);
  EXPECT_LT(line.valid_until(), 100);
}

// An independent check without event detection: small steps reverse the velocities of bodies that overlap. It converges
// as the step goes to zero.
TEST(Line, AgreesWithSmallStepsWithoutEventDetection) {
  const Particles start{{1, 3, 1, 0.2}, {2, -1, 2.5, 0.3}};
  const double e = 0.8;
  const Line line(start, {.left = 0, .right = 4}, {e, e, e}, 2);
  Particles now = start;
  constexpr int steps = 2000000;
  const double h = 2.0 / steps;
  for (int i = 0; i < steps; ++i) {
    for (Line::Particle& one : now) one.position += h * one.speed;
    if (now[0].position < now[0].half && now[0].speed < 0) now[0].speed *= -e;
    if (now[1].position > 4 - now[1].half && now[1].speed > 0) now[1].speed *= -e;
    const double approach = now[0].speed - now[1].speed;
    if (now[1].position - now[0].position < 0.5 && approach > 0) {
      const double impulse = (1 + e) * approach / (1 / now[0].mass + 1 / now[1].mass);
      now[0].speed -= impulse / now[0].mass;
      now[1].speed += impulse / now[1].mass;
    }
  }
  const Particles exact = at(line, 2, 2);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(exact[i].speed, now[i].speed, 1e-9);
    EXPECT_NEAR(exact[i].position, now[i].position, 1e-4);  // impacts are up to h late, with up to ten jumps of 5 m/s
  }
}

}  // namespace
}  // namespace plumb::line_test
