// Free nets of discs, each hinged to its neighbours: rigid but for one motion, in which each disc turns against its
// neighbours like meshed gears.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../real_literal.h"
#include "../support.h"
#include "impulse/impulse.h"

namespace impulse::inline IMPULSE_PRECISION::nets_test {
namespace {

constexpr double bound(double in_double, double in_float) {
  return sizeof(Real) == sizeof(double) ? in_double : in_float;
}

BodyId disc(World& world, Vec2 at, Vec2 velocity, Real restitution) {
  BodyDef def;
  def.position = at;
  def.velocity = velocity;
  return world.create_body(def, Shape::circle(0.4_r), {1, 0, 0, restitution});
}

/// A net of side x side discs of .4 m, 1 m apart, whose lower left one is struck by another at 4 m/s, along its lower
/// row, after .1 s.
struct StruckNet {
  World world;
  std::vector<BodyId> discs;
  BodyId striker;

  explicit StruckNet(std::size_t side, Real restitution) : world(settings()) {
    for (std::size_t row = 0; row < side; ++row) {
      for (std::size_t column = 0; column < side; ++column) {
        const auto x = static_cast<Real>(column);
        const auto y = static_cast<Real>(row);
        discs.push_back(disc(world, {x, y}, {}, restitution));
        const std::size_t here = discs.size() - 1;
        if (column > 0) world.create_joint(RevoluteJoint{discs[here - 1], discs[here], {x - 0.5_r, y}});
        if (row > 0) world.create_joint(RevoluteJoint{discs[here - side], discs[here], {x, y - 0.5_r}});
      }
    }
    striker = disc(world, {-1.2_r, 0}, {4, 0}, restitution);
  }
  static Settings settings() {
    Settings settings;
    settings.gravity = {0, 0};
    return settings;
  }
  void run_for(double seconds) {
    for (int i = 0; i < std::lround(60 * seconds); ++i) world.step();
  }
  double spin(std::size_t i) { return static_cast<double>(world.body(discs[i]).angular_velocity()); }
};

// Rounding, mended at once wherever it was more than it may be, made gears turn at .065 rad/s in float.
TEST(Nets, OfHingedDiscsTurnAsOneBodyAfterABlow) {
  for (const std::size_t side : {4U, 6U}) {
    StruckNet net(side, 0.5_r);
    net.run_for(.6);
    double least = net.spin(0);
    double most = least;
    for (std::size_t i = 0; i < net.discs.size(); ++i) {
      least = std::min(least, net.spin(i));
      most = std::max(most, net.spin(i));
    }
    EXPECT_GT(least, .05) << side;
    EXPECT_LT(most - least, bound(1e-9, 1e-3)) << side;
  }
}

// J = (1+e) v/(1/m + 1/M + y^2/I). The compliance of the hinges took 1e-4 of it; without a rebound the impact was none
// at a time of its own, and contacts and hinges, solved in turns, left 1e-5. What does not rebound goes on to push
// while the net turns.
TEST(Nets, OfMoreHingesThanAreSolvedAtOnceTakeAllOfABlow) {
  for (const double e : {0., 1.}) {
    constexpr std::size_t side = 8;
    StruckNet net(side, real(e));
    net.run_for(.2);
    const MassData one = net.world.body(net.striker).mass();
    const auto m = static_cast<double>(one.mass);
    double inertia = 0;  // about the middle
    for (std::size_t i = 0; i < side * side; ++i) {
      const double x = static_cast<double>(i % side) - 3.5;
      const std::size_t row = i / side;
      const double y = static_cast<double>(row) - 3.5;
      inertia += static_cast<double>(one.inertia) + m * (x * x + y * y);
    }
    const double impulse = (1 + e) * 4 / (1 / m + 1 / (side * side * m) + 3.5 * 3.5 / inertia);
    const double off = bound(e > 0 ? 1e-10 : 1e-7, 1e-4);
    EXPECT_NEAR(static_cast<double>(net.world.body(net.striker).velocity().x), 4 - impulse / m, off);
    EXPECT_NEAR(net.spin(0), 3.5 * impulse / inertia, off);
  }
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::nets_test
