#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/scenarios/statement_of.h"

namespace plumb::grazing_test {
namespace {

using statement_of::Of;

// In steps of a microsecond, the velocity turned round where the disc is at the wall.
TEST(Grazing, AgreesWithAnIntegrationInSmallSteps) {
  for (const Parameters& changes :
       std::vector<Parameters>{{}, {{"reach", 0.98}}, {{"reach", 1.4}, {"restitution", 0.9}, {"frequency", 6}}}) {
    const Scenario& family = *Catalog<Scenario>::find("grazing");
    const Parameters p = complete(family, changes);
    const double w = p.at("frequency");
    for (const Expectation& one : Of{"grazing", changes, "disc", Quantity::x}.expectations()) {
      constexpr double h = 1e-6;
      double x = -p.at("reach");
      double v = 0;
      for (double t = 0; t < *one.time; t += h) {
        v -= h / 2 * w * w * x;
        x += h * v;
        v -= h / 2 * w * w * x;
        if (x > 1 && v > 0) v *= -p.at("restitution");
      }
      EXPECT_NEAR(*one.expected, x, 2e-4);
    }
  }
}

// A^2 - d^2 falls by e^2: the second impact of one that reaches a fifth beyond is hardly felt.
TEST(Grazing, ApproachesTheWallAndNeverFallsShortOfIt) {
  const auto energies = Of{"grazing", {}, "", Quantity::energy}.expectations();
  const auto missed = Of{"grazing", {{"reach", 1 - 1e-9}}, "", Quantity::energy}.expectations();
  const double least = *missed.back().expected;
  EXPECT_NEAR((*energies.back().expected - least) / (*energies.front().expected - least), std::pow(0.5, 2), 1e-6);
}

// At the first impact 1 - e^2 of what is beyond d^2 is lost.
TEST(Grazing, StopsAWallThatIsNotThereOrTakesAll) {
  const Expectation first = Of{"grazing", {}, "", Quantity::energy}.expectations().front();
  const double whole = *first.expected * 1.44 / (1 + 0.25 * 0.44);
  EXPECT_LT(first.allowed(statement_of::accurate()), (whole - *first.expected) / 3);
  EXPECT_LT(first.allowed(statement_of::accurate()), *first.expected - whole / 1.44);
}

}  // namespace
}  // namespace plumb::grazing_test
