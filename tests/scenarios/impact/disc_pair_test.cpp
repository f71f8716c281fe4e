#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::disc_pair_test {
namespace {

using statement_of::Of;

const Scenario& family() { return *Catalog<Scenario>::find("disc-pair"); }

double expected(const Parameters& changes, const std::string& body, Quantity quantity) {
  return *Of{"disc-pair", changes, body, quantity}.expectations().front().expected;
}

const std::vector<Parameters> settings{{},
                                       {{"friction", 0.9}},
                                       {{"restitution", 0}},
                                       {{"restitution", 0}, {"friction", 0.9}, {"ratio", 0.2}},
                                       {{"restitution", 1}, {"incidence", -50}, {"first", -40}, {"friction", 0.4}}};

struct Motion {
  Vec velocity[2];
  double spin[2];
};

// Routh's method: the normal impulse is added in small parts, each with the friction that opposes the slip of that
// moment, until the normal velocity is -e times the approach.
Motion by_small_impulses(const Parameters& changes) {
  const Parameters p = complete(family(), changes);
  const Scene scene = family().scene(p);
  constexpr double across = 25 * 3.14159265358979323846 / 180;
  const Vec n{std::cos(across), std::sin(across)};
  const Vec t{-n.y, n.x};
  const double r[2] = {0.5, 0.4};
  Mass mass[2];
  Motion now{};
  for (int i = 0; i < 2; ++i) {
    mass[i] = mass_of(scene.bodies[static_cast<std::size_t>(i)]);
    now.velocity[i] = scene.bodies[static_cast<std::size_t>(i)].velocity;
    now.spin[i] = scene.bodies[static_cast<std::size_t>(i)].angular_velocity;
  }
  const auto along = [&](Vec axis) {
    return (now.velocity[0].x - now.velocity[1].x) * axis.x + (now.velocity[0].y - now.velocity[1].y) * axis.y;
  };
  const double approach = along(n);
  const double dp = mass[0].mass * approach * 1e-5;
  while (along(n) > -p.at("restitution") * approach) {
    const double slip = along(t) + now.spin[0] * r[0] + now.spin[1] * r[1];
    const double holds = std::abs(slip) / (1 / mass[0].mass + 1 / mass[1].mass + r[0] * r[0] / mass[0].inertia +
                                           r[1] * r[1] / mass[1].inertia);
    const double dt = std::copysign(std::min(p.at("friction") * dp, holds), slip);
    for (int i = 0; i < 2; ++i) {
      const double sign = i == 0 ? -1 : 1;
      now.velocity[i].x += sign * (dp * n.x + dt * t.x) / mass[i].mass;
      now.velocity[i].y += sign * (dp * n.y + dt * t.y) / mass[i].mass;
      now.spin[i] -= r[i] * dt / mass[i].inertia;
    }
  }
  return now;
}

TEST(DiscPair, AgreesWithRouthsSmallImpulses) {
  for (const Parameters& changes : settings) {
    const Motion end = by_small_impulses(changes);
    for (int i = 0; i < 2; ++i) {
      const std::string name = i == 0 ? "one" : "other";
      EXPECT_NEAR(expected(changes, name, Quantity::vx), end.velocity[i].x, 2e-3) << name;
      EXPECT_NEAR(expected(changes, name, Quantity::vy), end.velocity[i].y, 2e-3) << name;
      EXPECT_NEAR(expected(changes, name, Quantity::angular_velocity), end.spin[i], 5e-3) << name;
    }
  }
}

// About the world's origin, from the positions and velocities at the end.
TEST(DiscPair, KeepsMomentumAndAngularMomentum) {
  for (const Parameters& changes : settings) {
    const Scene scene = family().scene(complete(family(), changes));
    Vec before, after;
    double turning = 0;
    for (const Body& body : scene.bodies) {
      const Mass mass = mass_of(body);
      const Vec end{expected(changes, body.name, Quantity::vx), expected(changes, body.name, Quantity::vy)};
      before = {before.x + mass.mass * body.velocity.x, before.y + mass.mass * body.velocity.y};
      after = {after.x + mass.mass * end.x, after.y + mass.mass * end.y};
      turning += mass.mass * (expected(changes, body.name, Quantity::x) * end.y -
                              expected(changes, body.name, Quantity::y) * end.x) +
                 mass.inertia * expected(changes, body.name, Quantity::angular_velocity);
    }
    EXPECT_NEAR(after.x, before.x, 1e-12);
    EXPECT_NEAR(after.y, before.y, 1e-12);
    EXPECT_NEAR(turning, expected(changes, "", Quantity::angular_momentum), 1e-12);
  }
}

// A hoop keeps half of its slip where a disc keeps a third: what it would be off by, is seen by our own statement.
TEST(DiscPair, StopsAFrictionlessOne) {
  const Of spin{"disc-pair", {{"friction", 0.9}}, "one", Quantity::angular_velocity};
  const double change = std::abs(*spin.expectations().front().expected - 3);
  EXPECT_GT(change, 2);
  EXPECT_LT(spin.allows(statement_of::accurate()), change / 100);
  EXPECT_LT(spin.allows_at_most(), change);
}

const Scenario& off_center() { return *Catalog<Scenario>::find("off-center"); }

double expected(const Parameters& p, Quantity quantity) {
  for (const Expectation& one : off_center().expectations(p)) {
    if (one.quantity == quantity) return *one.expected;
  }
  ADD_FAILURE() << name_of(quantity);
  return 0;
}

// first-impact looks for the landing itself, and solves for the impulse at the corner that it finds.
TEST(OffCenter, AgreesWithTheClosedFormOfFirstImpactsForAPolygonInAnyFrame) {
  const Engine& exact = *Catalog<Engine>::find("first-impact");
  for (const double form : {0.0, 1.0}) {
    const Parameters p = complete(off_center(), {{"form", form}});
    const Scene scene = off_center().scene(p);
    const std::unique_ptr<Simulation> motion = exact.build(scene, complete(exact, {}));
    ASSERT_GT(motion->valid_until(), scene.duration) << "it lands again";
    motion->step(scene.duration);
    std::vector<BodyState> end(scene.bodies.size());
    motion->read(end);
    EXPECT_NEAR(expected(p, Quantity::x), end[1].position.x, 1e-12) << form;
    EXPECT_NEAR(expected(p, Quantity::y), end[1].position.y, 1e-12) << form;
    EXPECT_NEAR(expected(p, Quantity::vy), end[1].velocity.y, 1e-12) << form;
    EXPECT_NEAR(expected(p, Quantity::angle), end[1].angle, 1e-12) << form;
    EXPECT_NEAR(expected(p, Quantity::angular_velocity), end[1].angular_velocity, 1e-12) << form;
  }
}

TEST(OffCenter, KeepsTheEnergyOfAnElasticImpact) {
  for (const double form : {0.0, 1.0, 2.0}) {
    const Parameters p = complete(off_center(), {{"form", form}, {"restitution", 1}});
    const Mass mass = mass_of(off_center().scene(p).bodies[1]);
    const double v = expected(p, Quantity::vy);
    const double w = expected(p, Quantity::angular_velocity);
    EXPECT_GT(std::abs(w), 0.1) << form;
    EXPECT_NEAR(mass.mass * v * v + mass.inertia * w * w, mass.mass * p.at("speed") * p.at("speed"), 1e-12) << form;
  }
}

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
}  // namespace plumb::disc_pair_test
