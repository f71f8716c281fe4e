#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "reports/run/run.h"
#include "reports/run/selection.h"
#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::sliding_test {
namespace {

using statement_of::Of;

// Symplectic Euler on a body that touches the ground only from the second step on: it falls for one step, and the
// impact has the friction that was missing.
double speed_of_a_late_contact(double v, double mu, double time, double h) {
  double fall = 0;
  const int steps = static_cast<int>(std::lround(time / h));
  for (int i = 0; i < steps; ++i) {
    fall += 10 * h;
    if (i == 0) continue;
    v -= mu * fall;
    fall = 0;
  }
  return v;
}

TEST(Sliding, IsAsFastIfItsContactIsFoundLate) { EXPECT_NEAR(speed_of_a_late_contact(12, 0.4, 1, 1.0 / 60), 8, 1e-12); }

// Damping and Coulomb friction in small steps, of the velocity that a step has in its middle: where it is at a time.
double damped_place(double v, double c, double brake, double time) {
  constexpr double h = 1e-5;
  double x = 0;
  for (double t = 0; t < time && v > 0; t += h) {
    const double next = (v * (1 - c * h / 2) - brake * h) / (1 + c * h / 2);
    x += h * (v + std::max(next, 0.0)) / 2;
    v = next;
  }
  return x;
}

TEST(DampedSlide, AgreesWithAnIntegrationInSmallSteps) {
  for (const auto& [damping, friction] : {std::pair{1.0, 0.3}, std::pair{4.0, 0.1}, std::pair{0.1, 1.0}}) {
    const Parameters changes{{"damping", damping}, {"friction", friction}};
    for (const Expectation& one : (Of{"damped-slide", changes, "box", Quantity::x}.expectations())) {
      const double time = one.time.value_or(100);
      EXPECT_NEAR(*one.expected, damped_place(5, damping, 10 * friction, time), 1e-4) << damping << " at " << time;
    }
  }
}

// At half its time it slides at 1.9 m/s, without damping at 3.5 and without friction at 3.1.
TEST(DampedSlide, StopsABoxWithoutDampingOrFriction) {
  EXPECT_LT((Of{"damped-slide", {}, "box", Quantity::vx}.allows_at_most()), 1.2 / 4);
}

// Friction off by 2 % of itself, in the scenario with the least friction.
TEST(MixingRules, StopFrictionThatIsTwoPercentOff) {
  EXPECT_LT((Of{"mixing-rules", {}, "box", Quantity::vx}.allows_at_most()), 0.02 * 4);
  EXPECT_LT((Of{"mixing-rules", {{"rule", 5}}, "box", Quantity::vx}.allows_at_most()), 0.02 * 1.6);
}

TEST(Slope, StopsAFrictionlessBoxAndOneThatSticks) {
  const double angle = (std::atan(0.5) * 180 / 3.141592653589793) + 1;
  const Of slides{"slope", {{"angle", angle}, {"friction", 0.5}}, "box", Quantity::speed};
  EXPECT_LT(slides.allows_at_most(), 0.39 / 20);
}

// It turns by .38 rad in a second.
TEST(Tipping, StopsABoxThatDoesNotTip) {
  EXPECT_LT((Of{"tipping", {}, "box", Quantity::angle}.allows_at_most()), 0.379 / 5);
}

// A ladder of 38 degrees has turned by .087 rad when its top leaves the wall.
TEST(Ladder, StopsOneThatDoesNotSlide) {
  const Of angle{"ladder", {{"angle", 38}}, "ladder", Quantity::angle};
  EXPECT_LT(angle.allows_at_most(), 0.0865 / 2);
}

TEST(FlushTiles, StopABoxThatAnInnerEdgeSlowsByATenth) {
  EXPECT_LT((Of{"flush-tiles", {}, "box", Quantity::vx}.allows_at_most()), 4 / 10.);
}

double speed(double press, double friction) {
  return *Of{"pressed-box", {{"press", press}, {"friction", friction}}, "box", Quantity::vy}
              .expectations()
              .front()
              .expected;
}

TEST(PressedBox, FallsFreelyWithoutFrictionAndNotAtAllFromTheLimitOn) {
  EXPECT_NEAR(speed(20, 0), -10, 1e-12);
  EXPECT_NEAR(speed(0.1, 0.5), -10 + 0.05, 1e-12);
  EXPECT_NEAR(speed(20, 0.4999), 0, 0.01);
  EXPECT_EQ(speed(20, 0.5001), 0);
  EXPECT_EQ(speed(100, 0.5), 0);
}

TEST(PressedBox, StopsAFrictionlessOne) {
  EXPECT_LT((Of{"pressed-box", {}, "box", Quantity::vy}.allows_at_most()), 10.0 / 20);
  EXPECT_LT((Of{"pressed-box", {{"friction", 0.2}}, "box", Quantity::vy}.allows_at_most()), 4.0 / 2);
}

double expected(const Parameters& changes, Quantity quantity) {
  return *Of{"limiting-friction", changes, "box", quantity}.expectations().front().expected;
}

// Coulomb's law in steps of 0.1 ms: at rest friction balances up to its static limit, and once the box moves it brakes
// with the dynamic one.
TEST(LimitingFriction, AgreesWithAnIntegrationOfCoulombsLaw) {
  for (const double margin : {-0.05, -5e-5, 5e-5, 0.05}) {
    for (const double dynamic : {0.0, 0.3, 0.45}) {
      const Parameters changes{{"margin", margin}, {"dynamic", dynamic}};
      const Scenario& family = *Catalog<Scenario>::find("limiting-friction");
      const Scene scene = family.scene(complete(family, changes));
      const double pull = std::get<Constant>(scene.forces[0]).force.x / mass_of(scene.bodies[1]).mass;
      const Surface& rough = scene.bodies[1].shapes[0].surface;
      double x = 0;
      double v = 0;
      constexpr double h = 1e-4;
      for (int i = 0; i < 20000; ++i) {
        const bool sticks = v == 0 && pull <= rough.static_friction * 10;
        v += sticks ? 0 : h * (pull - rough.dynamic_friction * 10);
        x += h * v;
      }
      EXPECT_NEAR(expected(changes, Quantity::vx), v, 1e-9) << margin << ' ' << dynamic;
      EXPECT_NEAR(expected(changes, Quantity::x), x, 2e-3) << margin << ' ' << dynamic;
    }
  }
}

// Just beyond the limit the box is 6 m away at the end, just below it has not moved: a method that takes the wrong one
// of the two coefficients is stopped.
TEST(LimitingFriction, StopsTheWrongSideOfTheLimit) {
  const double breaks = expected({}, Quantity::x);
  EXPECT_NEAR(breaks, (0.6 * 10 * (1 + 5e-5) - 0.3 * 10) * 2, 1e-9);
  const Stepping stated = statement_of::accurate();
  EXPECT_LT((Of{"limiting-friction", {}, "box", Quantity::x}.allows(stated)), breaks / 100);
  EXPECT_LT((Of{"limiting-friction", {{"margin", -5e-5}}, "box", Quantity::x}.allows(stated)), breaks / 100);
}

struct Speeds {
  double expected = 0, measured = 0;  // m/s
};

// Soon after the jam, along the ground, of our engine with exact contacts.
Speeds speeds_of(const char* word, double dt) {
  const Case one = parse_cases(word).front();
  const std::vector<Expectation> all = one.scenario->expectations(one.parameters);
  const auto jam =
      std::find_if(all.begin(), all.end(), [](const Expectation& of) { return of.quantity == Quantity::vx; });
  if (jam == all.end()) return {};
  Scene scene = *one.scene;
  scene.duration = *jam->time;
  const Outcome outcome = run(scene, parse_engine("impulse:solver=exact"), dt);
  return {*jam->expected, outcome.trace->states(outcome.trace->size() - 1)[1].velocity.x};
}

// It jams in the first step, with arms that turn in it: an error of first order, at most 2.9 m/s times 3.2 rad/s dt.
TEST(PainleveRod, MovesOnAfterTheJamAsARodWhoseFootStandsOrSlides) {
  for (const char* word : {"painleve-rod:mu=2", "painleve-rod:mu=5"}) {
    const auto error = [&](double dt) {
      const Speeds speeds = speeds_of(word, dt);
      EXPECT_GT(speeds.expected, 2) << word;
      return std::abs(speeds.measured - speeds.expected);
    };
    constexpr double dt = 1.0 / 600;
    EXPECT_LT(error(dt), 2.9 * 3.2 * dt) << word;
    EXPECT_NEAR(error(dt) / error(dt / 4), 4, 0.1) << word;
    EXPECT_NEAR(error(dt / 4) / error(dt / 16), 4, 0.1) << word;
  }
}

}  // namespace
}  // namespace plumb::sliding_test
