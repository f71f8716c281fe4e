#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::struck_net_test {
namespace {

using statement_of::Of;

// After the blow.
struct Net {
  Scene scene;
  double spin, left;    // rad/s of the net, m/s of the striker
  Vec center, carried;  // of the net, m at the end and m/s

  explicit Net(const Parameters& changes) {
    const Scenario& family = *Catalog<Scenario>::find("struck-net");
    const Parameters p = complete(family, changes);
    scene = family.scene(p);
    const auto expected = [&](const std::string& body, Quantity quantity) {
      return *Of{"struck-net", changes, body, quantity}.expectations().front().expected;
    };
    const std::string n = std::to_string(static_cast<int>(2 * p.at("half")));
    spin = expected("1.1", Quantity::angular_velocity);
    left = expected("striker", Quantity::vx);
    // The middle between opposite corners: the lower left one follows from the angle.
    const double turned = expected("1.1", Quantity::angle);
    const double reach = (2 * p.at("half") - 1) / 2;
    center = {expected(n + "." + n, Quantity::x) - reach * (std::cos(turned) - std::sin(turned)),
              (expected("1.1", Quantity::y) + expected(n + "." + n, Quantity::y)) / 2};
    carried = {center.x / (turned / spin), center.y / (turned / spin)};
  }
};

// Momentum, angular momentum about the net's middle, and the velocities of the points that meet: three equations for
// three unknowns, none of them the closed form.
TEST(StruckNet, KeepsBothMomentaAndSeparatesWithItsRestitution) {
  for (const Parameters& changes : std::vector<Parameters>{
           {}, {{"half", 4}, {"restitution", 1}, {"ratio", 5}}, {{"restitution", 0}, {"half", 1}}}) {
    const Net net(changes);
    const Body& striker = net.scene.bodies.back();
    const double m = mass_of(striker).mass;
    const double y = striker.position.y;
    double mass = 0;
    double inertia = 0;
    for (std::size_t i = 0; i + 1 < net.scene.bodies.size(); ++i) {
      const Body& disc = net.scene.bodies[i];
      mass += mass_of(disc).mass;
      inertia += mass_of(disc).inertia + mass_of(disc).mass * std::pow(std::hypot(disc.position.x, disc.position.y), 2);
    }
    const double e = net.scene.bodies[0].shapes[0].surface.restitution;
    const double v = striker.velocity.x;
    EXPECT_NEAR(net.center.y, 0, 1e-12);
    EXPECT_NEAR(mass * net.carried.x + m * net.left, m * v, 1e-11);
    EXPECT_NEAR(inertia * net.spin - m * y * net.left, -m * y * v, 1e-11);
    EXPECT_NEAR(net.carried.x - net.spin * y - net.left, e * v, 1e-12);
  }
}

// As in single precision once, when what discs may turn by against each other took up rounding of their hinges.
TEST(StruckNet, StopsANetWhoseDiscsTurnAgainstEachOther) {
  Stepping in_float = statement_of::accurate();
  in_float.epsilon = 0x1p-24;
  EXPECT_LT((Of{"struck-net", {}, "1.1", Quantity::angular_velocity}.allows(in_float)), .065 / 50);
}

}  // namespace
}  // namespace plumb::struck_net_test
