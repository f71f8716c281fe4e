// Small islands in a blow, whose contacts are solved together.
#include "solver/contact_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION::contact_system_test {
namespace {

/// Boxes of several masses that fall and slide onto each other and the ground, inelastic, with friction.
std::vector<BodyDef> falling() {
  return {at(0, .5, 1), at(.95, .55, -.5, 0, 2, .2), at(.4, 1.7, 0, -3, 1, .4), at(-.9, .6, 2, -1, 0, .1)};
}

/// Where they are after a quarter of a second, still in motion, in the order of falling(), when they are listed in
/// another one.
std::vector<Vec2> places(const std::vector<std::size_t>& order) {
  World world(accurate());
  add_floor(world);
  const std::vector<BodyDef> defs = falling();
  std::vector<BodyId> ids(defs.size());
  for (const std::size_t i : order) {
    Material material;
    material.density = real(1 + 3.0 * static_cast<double>(i));
    ids[i] = world.create_body(defs[i], Shape::box(vec(.4, .3)), material);
  }
  run(world, 15);
  std::vector<Vec2> found;
  for (const BodyId id : ids) found.push_back(world.body(id).position());
  return found;
}

TEST(ContactSystem, MovesAPileAlikeInWhateverOrderItIsListed) {
  const std::vector<Vec2> first = places({0, 1, 2, 3});
  std::vector<std::size_t> order{0, 1, 2, 3};
  while (std::next_permutation(order.begin(), order.end())) {
    const std::vector<Vec2> then = places(order);
    for (std::size_t i = 0; i < first.size(); ++i) {
      EXPECT_NEAR(length(then[i] - first[i]), 0, sizeof(Real) == sizeof(double) ? 1e-10 : 1e-2) << "box " << i;
    }
  }
}

// What friction and contacts take is gone: no blow adds energy.
TEST(ContactSystem, AddsNoEnergyInABlow) {
  World world(accurate());
  add_floor(world);
  for (const BodyDef& def : falling()) world.create_body(def, Shape::box(vec(.4, .3)));
  const double first = energy(world);
  double last = first;
  for (int step = 0; step < 60; ++step) {
    world.step();
    EXPECT_LT(energy(world), last + 1e-4 * first) << "step " << step;
    last = energy(world);
  }
  EXPECT_LT(last, .5 * first);
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::contact_system_test
