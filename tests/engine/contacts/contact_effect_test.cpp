#include "contacts/contact_effect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "../support.h"

namespace impulse::inline IMPULSE_PRECISION::contact_effect_test {
namespace {

constexpr InverseMass one{1, 1};
constexpr InverseMass fixed{0, 0};

Vec2 direction(double angle) { return {real(std::cos(angle)), real(std::sin(angle))}; }

/// A contact of one point that lies `a` from one centre of mass and `b` from the other.
Contact touching(Vec2 normal, Vec2 a, Vec2 b) {
  Contact contact;
  contact.count = 1;
  contact.normal = normal;
  contact.points[0].arm_a = a;
  contact.points[0].arm_b = b;
  return contact;
}

PointArms arms(const Contact& contact) { return arms_of(contact, 0); }

struct Given {
  Vec2 impulse;
  Real about_a, about_b;
};

Given given(const Contact& contact, const std::array<Vec2, 2>& reported) {
  Given all{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(contact.count); ++i) {
    const Vec2 world = reported[i].x * contact.normal + reported[i].y * perpendicular(contact.normal);
    all.impulse += world;
    all.about_a += cross(contact.points[i].arm_a, world);
    all.about_b += cross(contact.points[i].arm_b, world);
  }
  return all;
}

TEST(ContactEffect, IsTheImpulseItselfIfNothingTurns) {
  Contact contact = touching({0, 1}, {1, real(.5)}, {real(-.25), real(-.5)});
  ContactEffect effect;
  effect.note(arms(contact), contact.normal, {3, 1});
  const std::array<Vec2, 2> got = reported(effect, {{{3, 1}, {}}}, one, one, contact);
  EXPECT_NEAR(got[0].x, 3, 1e-6);
  EXPECT_NEAR(got[0].y, 1, 1e-6);
  EXPECT_EQ(contact.normal, (Vec2{0, 1}));
  EXPECT_EQ(contact.points[0].arm_a, (Vec2{1, real(.5)}));
  EXPECT_TRUE(is_finite(contact.found_a.p));
}

TEST(ContactEffect, OfANormalThatTurnsIsOneImpulseThatTurnsBothBodiesAsMuch) {
  const Contact first = touching({0, 1}, {1, real(.5)}, {real(-.25), real(-.5)});
  Contact then = touching(direction(1.7), {real(.9), real(.6)}, {real(-.3), real(-.4)});
  ContactEffect effect;
  effect.note(arms(first), first.normal, {3, 1});
  effect.note(arms(then), then.normal, {2, real(-.5)});
  const Given is = given(then, reported(effect, {{{5, real(.5)}, {}}}, one, one, then));
  EXPECT_NEAR(length(is.impulse - effect.impulse), 0, 1e-5);
  EXPECT_NEAR(is.about_a, effect.turned_a, 1e-5);
  EXPECT_NEAR(is.about_b, effect.turned_b, 1e-5);
  EXPECT_FALSE(is_finite(then.found_a.p)) << "points that were moved must be found anew";
}

TEST(ContactEffect, MovesNoPointOfWhatCannotBePushed) {
  const Contact first = touching({0, 1}, {1, real(.5)}, {real(-.25), real(-.5)});
  Contact then = touching({0, 1}, {real(.9), real(.5)}, {real(-.3), real(-.5)});
  ContactEffect effect;
  effect.note(arms(first), first.normal, {3, 1});
  effect.note(arms(then), then.normal, {2, 0});
  const Given is = given(then, reported(effect, {{{5, 1}, {}}}, fixed, one, then));
  EXPECT_EQ(then.points[0].arm_a, (Vec2{real(.9), real(.5)}));
  EXPECT_NEAR(is.about_b, effect.turned_b, 1e-5);
}

TEST(ContactEffect, OfOppositeImpulsesIsNoneIfOnlyRoundingIsLeft) {
  Contact contact = touching(direction(.3), {1, 0}, {0, 1});
  ContactEffect effect;
  effect.note(arms(contact), contact.normal, {real(.1), real(.7)});
  effect.note(arms(contact), contact.normal, {real(-.1), real(-.7)});
  effect.impulse.x += std::numeric_limits<Real>::epsilon();
  EXPECT_EQ(given(contact, reported(effect, {{{1, 0}, {}}}, one, one, contact)).impulse, Vec2{});
}

TEST(ContactEffect, IsTakenBackWhole) {
  const Contact contact = touching(direction(.3), {1, real(.5)}, {real(-.25), real(-.5)});
  ContactEffect effect;
  effect.note(arms(contact), contact.normal, {3, 1});
  const ContactEffect pressed = effect;
  effect += -1 * pressed;
  EXPECT_EQ(effect.impulse, Vec2{});
  EXPECT_EQ(effect.turned_a, 0);
  EXPECT_EQ(effect.turned_b, 0);
  EXPECT_EQ(effect.given, 2 * pressed.given) << "so that what rounding leaves of it has no direction";
}

/// kg m^2/s, how much the moments of what a body's contacts report differ from what turned it in a step, at most, of
/// all that touch the ground alone; `seen` counts these.
Real missing_moment(World& world, BodyId ground, int& seen) {
  const std::span<const BodyId> all = world.bodies();
  std::vector<Real> then;
  for (const BodyId id : all) then.push_back(world.body(id).angular_velocity());
  world.step();
  std::vector<Real> moment(all.size());
  std::vector<bool> alone(all.size(), true);
  std::vector<bool> pushed(all.size(), false);
  const auto index = [&](BodyId id) {
    return static_cast<std::size_t>(std::find(all.begin(), all.end(), id) - all.begin());
  };
  for (const ContactInfo& contact : world.contacts()) {
    const Vec2 impulse =
        contact.normal_impulse * contact.normal + contact.tangent_impulse * perpendicular(contact.normal);
    const auto turn = [&](BodyId id, BodyId other, Vec2 by) {
      const std::size_t at = index(id);
      moment[at] += cross(contact.point - world.body(id).position(), by);
      alone[at] = alone[at] && other == ground;
      pushed[at] = true;
    };
    turn(contact.a, contact.b, -impulse);
    turn(contact.b, contact.a, impulse);
  }
  Real most = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i] == ground || !alone[i] || !pushed[i]) continue;
    Body body = world.body(all[i]);
    most = std::max(most, std::abs(body.mass().inertia * (body.angular_velocity() - then[i]) - moment[i]));
    ++seen;
  }
  return most;
}

TEST(ContactEffect, OfBoxesThatTumbleOnTheGroundIsWhatTurnsThem) {
  World world;
  const BodyId ground = add_floor(world, {1, real(.4), real(.4), 0});
  for (int i = 0; i < 10; ++i) {
    world.create_body(at(2 * i, .5, i % 3 - 1, -2, i % 7 - 3, .37 * i), Shape::box({real(.2), real(.3)}),
                      {1, real(.4), real(.4), real(.2)});
  }
  Real most = 0;
  int seen = 0;
  for (int step = 0; step < 60; ++step) most = std::max(most, missing_moment(world, ground, seen));
  EXPECT_GT(seen, 300);
  EXPECT_LT(most, 256 * round_off);
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::contact_effect_test
