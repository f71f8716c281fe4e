#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "scenarios/integrate.h"
#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::spring_stop_test {
namespace {

using statement_of::Of;

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
}  // namespace plumb::spring_stop_test
