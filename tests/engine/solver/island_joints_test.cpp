// Nets too large to be solved at once, under the default method. Smaller ones: tests/engine/joints.
#include "solver/island_joints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../support.h"

namespace impulse::inline IMPULSE_PRECISION::island_joints_test {
namespace {

constexpr bool is_double = sizeof(Real) == sizeof(double);

/// Discs a metre apart, hinged to their neighbours half-way, of which the first `held` of the upper row are fixed.
/// Nothing collides.
struct Net {
  static constexpr int side = 20;
  World world;
  std::vector<BodyId> discs;
  bool free;

  explicit Net(int held) : world(settings()), free(held == 0) {
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        BodyDef def = at(column, -row, .1 * row, -.1 * column);
        def.layers = 0;
        def.angular_velocity = -real(.1);
        if (row == 0 && column < held) def = fixed(def);
        discs.push_back(world.create_body(def, Shape::circle(real(.4))));
        const Vec2 p = def.position;
        // Between two fixed bodies a joint holds nothing.
        if (column > 0 && (row > 0 || column >= held)) hinge(1, p - Vec2{real(.5), 0});
        if (row > 0) hinge(side, p + Vec2{0, real(.5)});
      }
    }
  }

  static Settings settings() {
    Settings chosen;
    chosen.solver = "accurate";
    return chosen;
  }
  static BodyDef fixed(BodyDef def) {
    def.type = BodyType::fixed;
    def.velocity = {};
    def.angular_velocity = 0;
    return def;
  }
  void hinge(int back, Vec2 anchor) {
    world.create_joint(RevoluteJoint{discs[discs.size() - 1 - static_cast<std::size_t>(back)], discs.back(), anchor});
  }
  void stop() {
    for (const BodyId id : discs) {
      if (world.body(id).type() == BodyType::dynamic) world.body(id).set_velocity({}, 0);
    }
  }

  double mass() {
    double sum = 0;
    for (const BodyId id : discs) {
      if (world.body(id).type() == BodyType::dynamic) sum += static_cast<double>(world.body(id).mass().mass);
    }
    return sum;
  }
  /// J, of a free net from its centre of mass: else rounding of its fall is more than what it may gain.
  double energy() {
    Vec2 drift;
    if (free) {
      for (const BodyId id : discs) drift += world.body(id).velocity() / static_cast<Real>(discs.size());
    }
    double sum = 0;
    for (const BodyId id : discs) {
      const Body body = world.body(id);
      if (body.type() != BodyType::dynamic) continue;
      const double w = static_cast<double>(body.angular_velocity());
      const Real height = free ? Real{0} : -dot(world.gravity(), body.position());
      sum += static_cast<double>(body.mass().mass) *
                 static_cast<double>(length_squared(body.velocity() - drift) / 2 + height) +
             static_cast<double>(body.mass().inertia) * w * w / 2;
    }
    return sum;
  }
  double fastest() {
    double most = 0;
    for (const BodyId id : discs) most = std::max(most, static_cast<double>(length(world.body(id).velocity())));
    return most;
  }
  /// m, the widest of all hinges.
  double gap() {
    double widest = 0;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      if (i % side > 0) widest = std::max(widest, apart(i - 1, {real(.5), 0}, i));
      if (i >= side) widest = std::max(widest, apart(i - side, {0, -real(.5)}, i));
    }
    return widest;
  }
  double apart(std::size_t a, Vec2 arm, std::size_t b) {
    const auto point = [&](std::size_t i, Vec2 local) {
      const Body body = world.body(discs[i]);
      return body.position() + Rotation(body.angle()) * local;
    };
    return static_cast<double>(length(point(a, arm) - point(b, -arm)));
  }
};

// The upper row is fixed, each of its hinges bears a column: weight / (2 m w^2) along the line to the next disc's
// centre. No hinge ever bears more than the whole net.
TEST(IteratedJoints, HoldANetWithinTheGapThatItsWeightExplains) {
  Net net(Net::side);
  net.stop();
  const double omega = static_cast<double>(stated_errors(Net::settings()).joint_omega);
  const double one = static_cast<double>(net.world.body(net.discs.back()).mass().mass);
  const double of_a_column = (Net::side - 1) * 10 / (2 * omega * omega);
  double widest = 0;
  for (int i = 0; i < 600; ++i) {
    run(net.world, 1);
    widest = std::max(widest, net.gap());
  }
  EXPECT_LT(widest, net.mass() / one * 10 / (2 * omega * omega));
  double mean = 0;
  for (std::size_t i = 0; i < Net::side; ++i) mean += net.apart(i, {0, -real(.5)}, i + Net::side) / Net::side;
  EXPECT_NEAR(mean / of_a_column, 1, .1);
  EXPECT_LT(net.fastest(), 1e-3);
}

// What slows the discs where the energy bound is met must not slow their fall: rounding alone, of each disc's velocity
// in each of 240 sub-steps.
TEST(IteratedJoints, LetAFreeNetFallLikeOneBody) {
  Net net(0);
  const auto height = [&] {
    double sum = 0;
    for (const BodyId id : net.discs) sum += static_cast<double>(net.world.body(id).position().y);
    return sum / static_cast<double>(net.discs.size());
  };
  double speed = 0;
  for (const BodyId id : net.discs) speed += static_cast<double>(net.world.body(id).velocity().y);
  speed /= static_cast<double>(net.discs.size());
  const double before = height();
  run(net.world, 60);
  EXPECT_NEAR(height() - before, speed - 10. / 2, is_double ? 1e-12 : 1e-4);
}

TEST(IteratedJoints, NeverAddEnergyToANet) {
  for (const int held : {0, 1, 7}) {
    Net net(held);
    const double before = net.energy();
    const double scale = net.mass() * 10 * Net::side;
    for (int i = 0; i < 300; ++i) {
      run(net.world, 1);
      ASSERT_LE(net.energy(), before + (is_double ? 1e-12 : 1e-5) * scale) << held << " held, step " << i;
    }
    EXPECT_LT(net.gap(), .2) << held << " held";
  }
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::island_joints_test
