#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <variant>
#include <vector>

#include "scenarios/integrate.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::flight_test {
namespace {

using statement_of::Of;

constexpr double c = 0.8;  // 1/s

// After n steps of h within a second, from 4 m/s.
double damped(double factor, double h) { return 4 * std::pow(factor, 1 / h); }

TEST(LoneBodies, AllowDampingAtTheIntervalThatIsStated) {
  const Of speed{"lone-bodies", {}, "damped", Quantity::vx};
  Stepping stated = statement_of::soft();
  const double off = damped(1 / (1 + c * stated.dt), stated.dt) - 4 * std::exp(-c);
  EXPECT_GT(off, speed.allows(stated)) << "damped once a step, stated as at each sub-step";
  stated.damping_interval = stated.dt;
  EXPECT_LT(off, speed.allows(stated));
}

TEST(LoneBodies, AllowDampingOfTheOrderThatIsStated) {
  const Of speed{"lone-bodies", {}, "damped", Quantity::vx};
  const double exact = 4 * std::exp(-c);
  for (const Stepping& stated : {statement_of::skinned(), statement_of::accurate()}) {
    const double k = c * stated.h;
    const double first = std::abs(damped(1 / (1 + k), stated.h) - exact);
    const double second = std::abs(damped((1 - k / 2) / (1 + k / 2), stated.h) - exact);
    EXPECT_LT(second, speed.allows(stated));
    EXPECT_EQ(first < speed.allows(stated), stated.order == 1);
  }
}

struct Comet {
  Vec position, velocity;  // from the sun
  double strength;
};

Comet comet_of(const Parameters& changes) {
  const Scenario& family = *Catalog<Scenario>::find("flyby");
  const Scene scene = family.scene(complete(family, changes));
  const Vec sun = scene.bodies[0].position;
  const Vec at = scene.bodies[1].position;
  return {{at.x - sun.x, at.y - sun.y}, scene.bodies[1].velocity, std::get<Attraction>(scene.forces[0]).strength};
}

TEST(Flyby, AgreesWithAnIntegration) {
  for (const Parameters& changes : std::vector<Parameters>{{}, {{"nearest", 1}, {"eccentricity", 3}}}) {
    const Comet start = comet_of(changes);
    const auto rate = [&](const std::array<double, 4>& y) {
      const double r = std::hypot(y[0], y[1]);
      const double pull = start.strength / (r * r * r);
      return std::array<double, 4>{y[2], y[3], -pull * y[0], -pull * y[1]};
    };
    for (const std::size_t moment : {0u, 1u}) {
      const auto end =
          integrated(std::array<double, 4>{start.position.x, start.position.y, start.velocity.x, start.velocity.y},
                     moment == 0 ? 2 : 4, 20000, rate);
      const Quantity quantities[] = {Quantity::x, Quantity::y, Quantity::vx, Quantity::vy};
      const double sun[] = {0.5, -1, 0, 0};
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(*(Of{"flyby", changes, "comet", quantities[i]}.expectations()[moment].expected), sun[i] + end[i],
                    1e-8);
      }
    }
  }
}

// Rutherford: far away, tan(deflection/2) = k/(b v^2), with v and b from energy and angular momentum; and a hyperbola
// of eccentricity e turns by 2 asin(1/e).
TEST(Flyby, IsDeflectedAsRutherfordSays) {
  for (const double e : {1.2, 1.6, 5.0}) {
    const Comet start = comet_of({{"eccentricity", e}});
    const Vec r = start.position;
    const Vec v = start.velocity;
    const double far = std::sqrt(v.x * v.x + v.y * v.y - 2 * start.strength / std::hypot(r.x, r.y));
    const double b = std::abs(r.x * v.y - r.y * v.x) / far;
    EXPECT_NEAR(std::atan(start.strength / (b * far * far)), std::asin(1 / e), 1e-12) << e;
  }
}

// Half the attraction would turn it by half a radian less.
TEST(Flyby, StopsAnAttractionThatIsTenPercentOff) {
  const Of velocity{"flyby", {}, "comet", Quantity::vx};
  const double speed = std::hypot(comet_of({}).velocity.x, comet_of({}).velocity.y);
  EXPECT_LT(velocity.allows(statement_of::accurate()), speed / 1000);
  EXPECT_LT(velocity.allows(statement_of::skinned()), speed / 5);
}

TEST(ThrownWall, StopsBoxesThatPushEachOtherApartByASkin) {
  const Of corner{"thrown-wall", {}, "box 1", Quantity::x};
  EXPECT_LT(corner.allows_at_most(), .02 / 10);
}

// By steps of 1e-5 s, whose midpoints are off by 1e-10.
TEST(ThrownWall, FallsAsTheEquationsOfDampedFlightDo) {
  constexpr double h = 1e-5;
  for (const double damping : {0., .01, 1., 5.}) {
    double x = 0;
    double y = 0;
    double vx = 3;
    double vy = 4;
    for (int step = 0; step < 100000; ++step) {
      const double mx = vx - damping * vx * h / 2;
      const double my = vy + (-10 - damping * vy) * h / 2;
      x += h * mx;
      y += h * my;
      vx -= h * damping * mx;
      vy += h * (-10 - damping * my);
    }
    const auto expected = [&](Quantity quantity) {
      return Of{"thrown-wall", {{"damping", damping}}, "box 1", quantity}.expectations().front().expected.value();
    };
    EXPECT_NEAR(expected(Quantity::x), x, 1e-8) << damping;
    EXPECT_NEAR(expected(Quantity::y), y, 1e-8) << damping;
  }
}

// Forces that velocities change are off in a step that looks at them once, by c g t h^2/6 of the way, however little
// that is: of a damping of .01/s, 3e-7 m.
TEST(ThrownWall, AllowsForWeightThatDampingChangesWithinAStep) {
  constexpr double h = 1. / 240;
  const Stepping second_order{.dt = 1. / 60, .h = h, .drift = 0, .order = 2};
  for (const double damping : {1e-4, .01, 1.}) {
    const Of corner{"thrown-wall", {{"damping", damping}}, "box 1", Quantity::y};
    EXPECT_GT(corner.allows(second_order), damping * 10 * h * h / 6) << damping;
    EXPECT_LT(corner.allows(second_order), damping * 15 * h * h) << damping;
  }
}

// A way of v (1 - e^(-ct))/c changes by v (1 - 2/e) of a relative change of c = 1/s.
TEST(ThrownWall, StopsDampingThatIsTooWeak) {
  const Of corner{"thrown-wall", {{"damping", 1}}, "box 1", Quantity::x};
  EXPECT_LT(corner.allows(statement_of::accurate()), 3 * (1 - 2 / std::exp(1)) / 1000);
  EXPECT_LT(corner.allows(statement_of::skinned()), 3 * (1 - 2 / std::exp(1)) / 4);
}

}  // namespace
}  // namespace plumb::flight_test
