#include "reports/judge/contacts.h"

#include <gtest/gtest.h>

#include <vector>

namespace plumb::contacts_test {
namespace {

constexpr double slack = 1e-9;  // m

TEST(ContactsByPair, GathersPointsWhicheverBodyIsCalledA) {
  const std::vector<ContactState> contacts{
      {.a = 0, .b = 2, .normal = {0, 1}, .normal_impulse = 1, .tangent_impulse = 0.5, .separation = 0.25},
      {.a = 2, .b = 0, .normal = {0, -1}, .normal_impulse = 2, .tangent_impulse = 0.25, .separation = -0.5},
      {.a = 1, .b = 2, .separation = 1}};
  const ContactsByPair pairs = contacts_by_pair(contacts);
  ASSERT_EQ(pairs.size(), 2u);
  const PairContacts& both = pairs.at({0, 2});
  EXPECT_EQ(both.points.size(), 2u);
  EXPECT_EQ(both.normal_impulse, 3);
  EXPECT_EQ(both.tangent_impulse, 0.75);
  EXPECT_EQ(both.separation(), -0.5);
  EXPECT_EQ(both.points[1].normal, (Vec{0, 1}));
}

TEST(PairContacts, ActIfTheyPushOrOverlap) {
  const auto acts = [](double impulse, double separation) {
    const std::vector<ContactState> one{{.a = 0, .b = 1, .normal_impulse = impulse, .separation = separation}};
    return contacts_by_pair(one).at({0, 1}).acts(slack);
  };
  EXPECT_TRUE(acts(1, 0.25));
  EXPECT_TRUE(acts(0, -1e-6));
  EXPECT_FALSE(acts(0, 0.25));
  EXPECT_FALSE(acts(0, -1e-12)) << "round-off";
}

ContactState contact_at(double x, double normal_impulse, std::size_t b = 1) {
  return {.a = 0, .b = b, .point = {x, 0}, .normal_impulse = normal_impulse};
}

TEST(ImpulseChange, IsFromTheNearestContactOfItsPair) {
  const std::vector<ContactState> before{contact_at(-1, 2), contact_at(1, 5), contact_at(0.9, 7, 2)};
  EXPECT_EQ(impulse_change(before, contact_at(0.9, 4)), 1);
  EXPECT_EQ(impulse_change(before, contact_at(-0.9, 4)), 2);
}

TEST(ImpulseChange, IsTheWholeImpulseIfThePairDidNotTouch) { EXPECT_EQ(impulse_change({}, contact_at(0, 4)), 4); }

TEST(StaleImpulseError, IsTheChangeOfAStepOrOfTheLastIteration) {
  const std::vector<ContactState> before{contact_at(0, 2)};
  const std::vector<ContactState> now{contact_at(0, 3), contact_at(0, 27, 2)};
  using Errors = std::vector<double>;
  EXPECT_EQ(stale_impulse_error(before, now, {.drift = 0}), (Errors{0, 0}));
  EXPECT_EQ(stale_impulse_error(before, now, {.drift = 0.5}), (Errors{1, 27}));
  // (2/3)^2/3 of 27
  EXPECT_EQ(stale_impulse_error(before, now, {.drift = 0.5, .iterations = 2}), (Errors{4, 27}));
}

}  // namespace
}  // namespace plumb::contacts_test
