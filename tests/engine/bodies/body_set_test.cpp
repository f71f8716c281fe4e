#include "bodies/body_set.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "../support.h"

namespace body_set_test {
namespace {

using namespace impulse;

// An L of a standing box 1 x 3 and a box 2 x 1 at its foot, density 2: 6 kg at (.5, 1.5) and 4 kg at (2, .5).
std::array<Part, 2> letter_l() {
  const Material material{2, 0, 0, 0};
  return {Part{Shape::box({Real{0.5}, Real{1.5}}, {Real{0.5}, Real{1.5}}), material},
          Part{Shape::box({1, Real{0.5}}, {2, Real{0.5}}), material}};
}

TEST(TotalMass, OfAnLFollowsTheParallelAxisTheorem) {
  const MassData mass = total_mass(letter_l());
  EXPECT_NEAR(mass.mass, 10, 10 * 4 * round_off);
  EXPECT_NEAR(mass.center.x, 1.1, 2 * 8 * round_off);
  EXPECT_NEAR(mass.center.y, 1.1, 2 * 8 * round_off);
  // m (w^2 + h^2)/12 + m d^2 for each.
  const double standing = 6 * (1 + 9) / 12.0 + 6 * (.6 * .6 + .4 * .4);
  const double foot = 4 * (4 + 1) / 12.0 + 4 * (.9 * .9 + .6 * .6);
  EXPECT_NEAR(mass.inertia, standing + foot, 16 * 16 * round_off);
}

TEST(TotalMass, DoesNotDependOnTheFrame) {
  std::array<Part, 2> parts = letter_l();
  const Real inertia = total_mass(parts).inertia;
  for (Part& part : parts) part.shape = part.shape.moved({-3, 2});
  EXPECT_NEAR(total_mass(parts).inertia, inertia, 16 * 32 * round_off);
  EXPECT_NEAR(total_mass(parts).center.x, -1.9, 4 * 8 * round_off);
}

TEST(TotalMass, OfPartsWithoutDensityIsZero) {
  const Part part{Shape::circle(1), {0, 0, 0, 0}};
  EXPECT_EQ(total_mass(std::span(&part, 1)).mass, 0);
}

TEST(BodySet, StoresPartsRelativeToTheCentreOfMass) {
  BodySet bodies;
  BodyDef def = at(10, 20);
  def.angle = pi / 2;
  const std::array<Part, 2> parts = letter_l();
  const std::size_t i = bodies.add(def, parts).index;
  EXPECT_NEAR(bodies.pose[i].p.x, 10 - 1.1, 32 * round_off);
  EXPECT_NEAR(bodies.pose[i].p.y, 20 + 1.1, 32 * round_off);
  EXPECT_NEAR(bodies.detail[i].parts[0].shape.centroid().x, 0.5 - 1.1, 8 * round_off);
  EXPECT_NEAR(bodies.bounding_radius[i], std::hypot(1.9, 1.1), 16 * round_off);
}

TEST(BodySet, GivesFixedAndKinematicBodiesNoInverseMass) {
  for (const BodyType type : {BodyType::fixed, BodyType::kinematic}) {
    BodySet bodies;
    BodyDef def;
    def.type = type;
    const Part part{Shape::circle(1), {}};
    const std::size_t i = bodies.add(def, std::span(&part, 1)).index;
    bodies.insert(i);
    EXPECT_EQ(bodies.inverse_mass[i].m, 0);
    EXPECT_EQ(bodies.inverse_mass[i].i, 0);
    EXPECT_EQ(bodies.detail[i].mass.mass, 0);
  }
}

TEST(BodySet, ReusesTheLastFreedRow) {
  BodySet bodies;
  const Part part{Shape::circle(1), {}};
  const std::span parts(&part, 1);
  for (int i = 0; i < 4; ++i) bodies.add({}, parts);
  bodies.destroy(1);
  bodies.destroy(2);
  EXPECT_EQ(bodies.add({}, parts), (BodyId{2, 1}));
  EXPECT_EQ(bodies.add({}, parts), (BodyId{1, 1}));
  EXPECT_EQ(bodies.add({}, parts), (BodyId{4, 0}));
}

TEST(BodySet, MakesRowsOfRemovedBodiesInert) {
  BodySet bodies;
  const Part part{Shape::circle(1), {}};
  const std::size_t i = bodies.add(at(0, 0, 3, 4), std::span(&part, 1)).index;
  EXPECT_EQ(bodies.inverse_mass[i].m, 0);
  bodies.insert(i);
  EXPECT_EQ(bodies.velocity[i].v, (Vec2{3, 4}));
  bodies.remove(i);
  EXPECT_EQ(bodies.velocity[i].v, (Vec2{0, 0}));
  EXPECT_EQ(bodies.inverse_mass[i].m, 0);
  EXPECT_EQ(bodies.velocity_of(i).v, (Vec2{3, 4}));
}

TEST(BodySet, DoesNotWrapAngles) {
  BodySet bodies;
  BodyDef def;
  def.angular_velocity = 1;
  const Part part{Shape::circle(1), {}};
  const std::size_t i = bodies.add(def, std::span(&part, 1)).index;
  bodies.insert(i);
  for (int step = 0; step < 16; ++step) bodies.advance(i, 1);
  EXPECT_EQ(bodies.angle[i], 16);
  EXPECT_EQ(bodies.pose[i].q, Rotation(Real{16}));
}

}  // namespace
}  // namespace body_set_test
