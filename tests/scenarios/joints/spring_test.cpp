#include <gtest/gtest.h>

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "scenarios/integrate.h"
#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::spring_test {
namespace {

using statement_of::Of;

double mass_of_first(const Scene& scene) { return mass_of(scene.bodies.front()).mass; }

TEST(Beats, AgreeWithAnIntegration) {
  const Scenario& family = *Catalog<Scenario>::find("beats");
  for (const Parameters& changes : std::vector<Parameters>{{}, {{"alike", 3}, {"ratio", 3}}}) {
    const Scene scene = family.scene(complete(family, changes));
    const double k = std::get<Spring>(scene.forces[0]).stiffness / mass_of_first(scene);
    const double c = std::get<Spring>(scene.forces[2]).stiffness / mass_of_first(scene);
    const auto rate = [&](const std::array<double, 4>& y) {
      return std::array<double, 4>{y[2], y[3], -k * y[0] + c * (y[1] - y[0]), -k * y[1] + c * (y[0] - y[1])};
    };
    for (const std::size_t moment : {0u, 1u}) {
      const auto end = integrated(std::array<double, 4>{0.6, 0, 0, 0}, moment == 0 ? 3.15 : 5, 20000, rate);
      EXPECT_NEAR(*(Of{"beats", changes, "struck", Quantity::x}.expectations()[moment].expected), end[0], 1e-9);
      EXPECT_NEAR(*(Of{"beats", changes, "coupled", Quantity::x}.expectations()[moment].expected), 2 + end[1], 1e-9);
    }
  }
}

// About when the other disc has all the energy, the one that was struck is at rest where it belongs.
TEST(Beats, StopDiscsThatAreNotCoupled) {
  const double alone = 0.6;  // m, by which the struck disc would still swing
  EXPECT_LT((Of{"beats", {}, "struck", Quantity::x, 4}.allows(statement_of::skinned())), alone / 4);
  EXPECT_LT((Of{"beats", {}, "struck", Quantity::x, 4}.allows(statement_of::accurate())), alone / 50);
}

TEST(SpringEllipse, AgreesWithAnIntegration) {
  const Scenario& family = *Catalog<Scenario>::find("spring-ellipse");
  const Scene scene = family.scene(complete(family, {}));
  const double k = std::get<Spring>(scene.forces[0]).stiffness / mass_of_first(scene);
  const Vec about = std::get<Spring>(scene.forces[0]).anchor_a;
  const Body& disc = scene.bodies[0];
  const auto end = integrated(std::array<double, 4>{disc.position.x, disc.position.y, disc.velocity.x, disc.velocity.y},
                              5, 20000, [&](const std::array<double, 4>& y) {
                                return std::array<double, 4>{y[2], y[3], -k * (y[0] - about.x), -k * (y[1] - about.y)};
                              });
  EXPECT_NEAR(*(Of{"spring-ellipse", {}, "disc", Quantity::x}.expectations().front().expected), end[0], 1e-9);
  EXPECT_NEAR(*(Of{"spring-ellipse", {}, "disc", Quantity::y}.expectations().front().expected), end[1], 1e-9);
}

}  // namespace
}  // namespace plumb::spring_test
