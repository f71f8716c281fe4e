#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "scenarios/integrate.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::bounce_test {
namespace {

using statement_of::Of;

const Scenario& bounce() { return *Catalog<Scenario>::find("bounce"); }

// The simplest engine: symplectic Euler, a contact if the disc overlaps at the start of a step, and the velocity
// reversed in that step. `lift` moves the disc out of the ground. Returns the vertices through a trace of every step.
std::vector<double> apexes(const Parameters& p, double h, bool lift) {
  const double radius = p.at("radius");
  std::vector<double> tops;
  double y = p.at("height") + radius;
  double v = 0;
  double before = y;
  bool hit = false;
  for (double t = 0; t < 10; t += h) {
    const bool touches = y <= radius;
    if (touches && lift) y = radius;
    v -= 10 * h;
    if (touches && v < 0) {
      v *= -p.at("restitution");
      hit = true;
    }
    const double next = y + h * v;
    if (hit && next < y && y >= before) {
      tops.push_back(y - (next - before) * (next - before) / (8 * (next - 2 * y + before)));
      hit = false;
    }
    before = y;
    y = next;
  }
  return tops;
}

TEST(Bounce, AllowsTheErrorsOfASimpleEngineAtEveryPhaseOfTheImpact) {
  const double h = 1.0 / 60;
  const Stepping stepping{.dt = h, .h = h, .drift = 0.5, .epsilon = 0x1p-53};
  for (const double e : {0.5, 0.8, 1.0}) {
    for (int phase = 0; phase < 50; ++phase) {
      const Parameters p = complete(bounce(), {{"restitution", e}, {"height", 4 + 0.003 * phase}});
      for (const bool lift : {false, true}) {
        const std::vector<double> tops = apexes(p, h, lift);
        for (const Expectation& expectation : bounce().expectations(p)) {
          if (expectation.quantity != Quantity::apex) continue;
          const auto n = static_cast<std::size_t>(expectation.index);
          ASSERT_GE(tops.size(), n);
          EXPECT_NEAR(tops[n - 1], *expectation.expected, expectation.allowed(stepping))
              << e << ' ' << n << ' ' << lift;
        }
      }
    }
  }
}

TEST(Bounce, AllowsAtMostThreeTimesTheWorstErrorOfThatEngine) {
  const double h = 1.0 / 60;
  const Stepping stepping{.dt = h, .h = h, .drift = 0.5, .epsilon = 0x1p-53};
  for (const double e : {0.8, 1.0}) {
    double worst = 0;
    double allowed = 0;
    for (int phase = 0; phase < 50; ++phase) {
      const Parameters p = complete(bounce(), {{"restitution", e}, {"height", 4 + 0.003 * phase}});
      const Expectation first = bounce().expectations(p).front();
      allowed = first.allowed(stepping);
      for (const bool lift : {false, true}) {
        worst = std::max(worst, std::abs(apexes(p, h, lift).front() - *first.expected));
      }
    }
    EXPECT_LT(allowed, 3 * worst) << e;
  }
}

// Of 35.3 J. An engine that moves first and reverses in place keeps its energy exactly.
TEST(Bounce, StopsAnEngineThatLosesFortyPercentAtFullRestitution) {
  const statement_of::Of lost{"bounce", {{"restitution", 1}}, "", Quantity::energy, std::nullopt, Relation::at_least};
  EXPECT_LT(lost.allows(statement_of::positions_first()), 15.4 / 10);
  EXPECT_LT(lost.allows(statement_of::accurate()), 15.4 / 1000);
}

// A reading at samples alone would allow a step, 17 ms, whatever the method.
TEST(Bounce, AllowsAMethodThatSolvesForImpactsOnlyRounding) {
  const statement_of::Of landing{"bounce", {}, "disc", Quantity::landing};
  const statement_of::Of apex{"bounce", {}, "disc", Quantity::apex};
  Stepping exact = statement_of::accurate();
  exact.skin = 0;
  EXPECT_LT(landing.allows(exact), 1e-9);
  EXPECT_LT(apex.allows(exact), 1e-9);
}

// A flight of less than a few samples has no apex to see; without any, the fall is what is asked.
TEST(Bounce, AsksOnlyForFlightsThatSamplesResolve) {
  const auto count = [](double e, Quantity quantity) {
    const auto all = bounce().expectations(complete(bounce(), {{"restitution", e}}));
    return std::count_if(all.begin(), all.end(), [&](const Expectation& one) { return one.quantity == quantity; });
  };
  EXPECT_EQ(count(0.8, Quantity::apex), 3);
  EXPECT_EQ(count(0.2, Quantity::apex), 1);
  EXPECT_EQ(count(0.2, Quantity::landing), 1);
  EXPECT_EQ(count(0, Quantity::apex), 0);
  EXPECT_EQ(count(0, Quantity::y), 2);
}

// Half of gravity lands sqrt 2 later: at 1.26 instead of .89 s.
TEST(Bounce, StopsHalfGravity) {
  EXPECT_LT((statement_of::Of{"bounce", {}, "disc", Quantity::landing}.allows_at_most()), 0.37 / 5);
}

TEST(SpringStop, AgreesWithAnIntegrationThatReflects) {
  for (const Parameters& changes : std::vector<Parameters>{{}, {{"restitution", 1}, {"frequency", 7.3}}}) {
    const Parameters p = complete(*Catalog<Scenario>::find("spring-stop"), changes);
    const double w = p.at("frequency");
    const auto rate = [&](const std::array<double, 2>& y) { return std::array<double, 2>{y[1], -w * w * y[0]}; };
    std::array<double, 2> now{p.at("amplitude"), 0};
    for (int i = 0; i < 200000; ++i) {
      now = runge_kutta(now, 1e-5, rate);
      if (now[0] < 0 && now[1] < 0) now[1] *= -p.at("restitution");
    }
    EXPECT_NEAR(*(Of{"spring-stop", changes, "disc", Quantity::x}.expectations().front().expected), 2 + now[0], 1e-3);
    EXPECT_NEAR(*(Of{"spring-stop", changes, "disc", Quantity::vx}.expectations().front().expected), now[1], 1e-2);
  }
}

// One that does not bounce stays at the wall; one that keeps all its speed has e^-6 times the energy.
TEST(SpringStop, StopsWrongRestitution) {
  const Of energy{"spring-stop", {}, "", Quantity::energy};
  const double left = *energy.expectations().front().expected;
  const Scenario& family = *Catalog<Scenario>::find("spring-stop");
  const double start = mass_of(family.scene(complete(family, {})).bodies[1]).mass * 4.5 * 4.5 * 1.2 * 1.2 / 2;
  EXPECT_NEAR(left, start * std::pow(0.8, 6), 1e-12);
  EXPECT_LT(energy.allows(statement_of::accurate()), left / 100);
  EXPECT_LT(energy.allows(statement_of::positions_first()), start - left);
}

}  // namespace
}  // namespace plumb::bounce_test
