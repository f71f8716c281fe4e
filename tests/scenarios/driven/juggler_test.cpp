#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scenarios/scene/scene.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::juggler_test {
namespace {

using statement_of::Of;

double last(const Parameters& changes, Quantity quantity) {
  return *Of{"juggler", changes, "ball", quantity}.expectations().back().expected;
}

double last_reading(const Parameters& changes) {
  return *Of{"juggler", changes, "ball", Quantity::y}.expectations().back().time;
}

// The ball over the scene's own table, in steps of a microsecond: the impact is in the first that ends below the table.
TEST(Juggler, AgreesWithAnIntegrationInSmallSteps) {
  for (const Parameters& changes : std::vector<Parameters>{
           {}, {{"off", 0.3}}, {{"restitution", 0.7}, {"off", -0.2}}, {{"share", 1.1}, {"off", 0.05}}}) {
    const Scenario& family = *Catalog<Scenario>::find("juggler");
    const Parameters p = complete(family, changes);
    const Scene scene = family.scene(p);
    const Path& path = *scene.bodies[0].path;
    constexpr double h = 1e-6;
    const double base = scene.bodies[0].position.y + 0.5 + 0.25;  // half the table and the ball's radius
    const auto table = [&](double t) { return base + path_offset(path, t).y; };
    double y = scene.bodies[1].position.y;
    double v = scene.bodies[1].velocity.y;
    const auto steps = static_cast<int>(last_reading(changes) / h);
    for (int i = 0; i < steps; ++i) {
      y += h * (v - 5 * h);
      v -= 10 * h;
      const double moves = (table((i + 1) * h) - table(i * h)) / h;
      if (y >= table((i + 1) * h) || v >= moves) continue;
      v = moves - p.at("restitution") * (v - moves);
    }
    EXPECT_NEAR(last(changes, Quantity::y), y, 1e-4);
    EXPECT_NEAR(last(changes, Quantity::vy), v, 1e-4);
  }
}

// Holmes' orbit: it leaves at g T/2, always from the same height.
TEST(Juggler, RepeatsItselfOnItsOrbit) {
  const auto heights = Of{"juggler", {}, "ball", Quantity::y}.expectations();
  const auto speeds = Of{"juggler", {}, "ball", Quantity::vy}.expectations();
  EXPECT_NEAR(*heights.front().expected, *heights.back().expected, 1e-9);
  EXPECT_NEAR(*speeds.front().expected, 10 * (1 - 0.2), 1e-9) << "a tenth of 2 s after the impact at 10 m/s";
}

// The map's eigenvalues are near e, nearly equal: after n impacts n e^n is left, four between the readings.
TEST(Juggler, SettlesToItsOrbit) {
  const auto off = [](std::size_t which) {
    const auto on = Of{"juggler", {}, "ball", Quantity::vy}.expectations();
    const auto beside = Of{"juggler", {{"off", 0.05}}, "ball", Quantity::vy}.expectations();
    return std::abs(*beside[which].expected - *on[which].expected);
  };
  EXPECT_GT(off(0), 1e-3);
  EXPECT_LT(off(1), off(0) / 3);
}

// Past the limit the map's slow eigenvalue is below -1: each bounce is farther off the orbit, on the other side.
TEST(Juggler, LeavesAnOrbitThatIsNotStable) {
  const auto off = [](double share, std::size_t which) {
    const auto on = Of{"juggler", {{"share", share}}, "ball", Quantity::vy}.expectations();
    const auto beside = Of{"juggler", {{"share", share}, {"off", 0.01}}, "ball", Quantity::vy}.expectations();
    return *beside[which].expected - *on[which].expected;
  };
  EXPECT_GT(std::abs(off(1.1, 1)), 1.5 * std::abs(off(1.1, 0)));
  EXPECT_LT(std::abs(off(0.9, 1)), std::abs(off(0.9, 0)));
}

// On a table that stands the ball loses half of its speed at the first impact.
TEST(Juggler, StopsATableThatStands) {
  const Of early{.scenario = "juggler", .changes = {}, .body = "ball", .quantity = Quantity::vy, .before = 2};
  EXPECT_LT(early.allows_at_most(), 5);
}

}  // namespace
}  // namespace plumb::juggler_test
