#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "scenarios/integrate.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::bowl_test {
namespace {

using statement_of::Of;

struct Disc {
  Vec place, velocity;
  double spin = 0;  // rad/s
  double angle = 0;
};

// In small steps, without pieces or events: of all planes the disc touches the nearest. It rolls along that, and where
// another becomes the nearest, it keeps its angular momentum about the point where it meets that.
Disc rolled(double kink, double start, double time) {
  constexpr double radius = 0.5;
  constexpr double gravity = 10;
  constexpr double round = 3;
  constexpr int steps = 2000000;
  const double h = time / steps;
  const auto normal = [&](int piece) { return Vec{-std::sin(piece * kink), std::cos(piece * kink)}; };
  const auto height = [&](const Vec& at, int piece) {
    const Vec n = normal(piece);
    return n.x * at.x + n.y * (at.y - round) + round - radius;
  };
  auto piece = static_cast<int>(std::lround(start / kink));
  const Vec n = normal(piece);
  Disc disc{{-(round - radius) * n.x, round - (round - radius) * n.y}, {}};
  for (int i = 0; i < steps; ++i) {
    for (const int next : {piece - 1, piece + 1}) {
      const Vec m = normal(next);
      const bool nears = disc.velocity.x * m.x + disc.velocity.y * m.y < 0;
      if (!nears || height(disc.place, next) > 0) continue;
      const double momentum =
          radius * (disc.velocity.x * m.y - disc.velocity.y * m.x) - radius * radius / 2 * disc.spin;
      const double speed = momentum / (1.5 * radius);
      piece = next;
      disc.velocity = {speed * m.y, -speed * m.x};
      disc.spin = -speed / radius;
      break;
    }
    const Vec m = normal(piece);
    const double speed = disc.velocity.x * m.y - disc.velocity.y * m.x + 2.0 / 3 * gravity * m.x * h;
    disc.velocity = {speed * m.y, -speed * m.x};
    disc.spin = -speed / radius;
    disc.place = {disc.place.x + h * disc.velocity.x, disc.place.y + h * disc.velocity.y};
    disc.angle += h * disc.spin;
  }
  return disc;
}

TEST(Bowl, AgreesWithAnIntegrationInSmallSteps) {
  constexpr double degree = std::numbers::pi / 180;
  for (const double kink : {15.0, 30.0}) {
    const Parameters changes{{"kink", kink}};
    const double start = -kink * std::round(45 / kink);
    for (const Expectation& one : Of{"bowl", changes, "disc", Quantity::x}.expectations()) {
      EXPECT_NEAR(*one.expected, rolled(kink * degree, start * degree, *one.time).place.x, 2e-5)
          << kink << ' ' << *one.time;
    }
    for (const Expectation& one : Of{"bowl", changes, "disc", Quantity::angle}.expectations()) {
      EXPECT_NEAR(*one.expected, rolled(kink * degree, start * degree, *one.time).angle, 5e-5)
          << kink << ' ' << *one.time;
    }
  }
}

// One that slides has no angle. One that loses nothing at a kink has rolled by .84 rad more in the middle of the run,
// more than any statement but that of skins of 2 cm on a disc of half a metre allows.
TEST(Bowl, StopsAnEngineThatSlidesOrLosesNothingAtAKink) {
  const Expectation angle = Of{"bowl", {{"kink", 30}}, "disc", Quantity::angle}.expectations().front();
  for (const Stepping& stated : statement_of::all()) EXPECT_LT(angle.allowed(stated), std::abs(*angle.expected) / 4);
  constexpr double lossless = -8.84656;  // rad, at 1.5 s
  for (const Stepping& stated : {statement_of::positions_first(), statement_of::accurate()}) {
    EXPECT_LT(angle.allowed(stated), *angle.expected - lossless);
  }
}

constexpr double swings = 2.5;  // m, the radius on which the disc's centre moves
constexpr double pi = 3.14159265358979323846;

double expected_x(double degrees, double kink, std::size_t reading) {
  return *Of{"arc-bowl", {{"angle", degrees}, {"kink", kink}}, "disc", Quantity::x}.expectations().at(reading).expected;
}

// (3/2) m (R - r)^2 q'' = -m g (R - r) sin q: with ever smaller kinks the segments are an arc, and the difference is of
// first order in the kinks.
TEST(ArcBowl, TendsToAPendulumOnItsArc) {
  for (const double degrees : {21.0, 60.0}) {
    const auto all = Of{"arc-bowl", {{"angle", degrees}}, "disc", Quantity::x}.expectations();
    for (const std::size_t reading : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
      const auto rate = [](const std::array<double, 2>& s) {
        return std::array<double, 2>{s[1], -10 / (1.5 * swings) * std::sin(s[0])};
      };
      const double angle =
          integrated(std::array<double, 2>{-degrees * pi / 180, 0}, *all[reading].time, 10000, rate)[0];
      const double arc = swings * std::sin(angle);
      const double coarse = expected_x(degrees, 3, reading) - arc;
      const double fine = expected_x(degrees, 0.5, reading) - arc;
      EXPECT_LT(std::abs(fine), 0.02) << degrees;
      if (reading == 1) {
        EXPECT_LT(std::abs(fine), std::abs(coarse) / 3) << "where it turns back";
      }
    }
  }
}

// The period grows with the amplitude as 1/agm(1, cos(a/2)): the duration is three quarters of it.
TEST(ArcBowl, LastsLongerForALargerAmplitude) {
  const Scenario& family = *Catalog<Scenario>::find("arc-bowl");
  const auto duration = [&](double degrees) { return family.scene(complete(family, {{"angle", degrees}})).duration; };
  const double small = 0.75 * 2 * pi * std::sqrt(1.5 * swings / 10);
  EXPECT_NEAR(duration(10), small * (1 + std::pow(10 * pi / 180, 2) / 16), 1.0 / 60);
  EXPECT_NEAR(duration(60), small * 1.0732, 1.0 / 60);
}

// One that slides without friction swings faster by sqrt(3/2).
TEST(ArcBowl, StopsADiscThatSlides) {
  EXPECT_LT((Of{"arc-bowl", {}, "disc", Quantity::x}.allows(statement_of::accurate())), 0.1);
  EXPECT_LT((Of{"arc-bowl", {}, "disc", Quantity::angle}.allows_at_most()), 2);
}

}  // namespace
}  // namespace plumb::bowl_test
