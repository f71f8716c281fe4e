#include "impulse/material.h"

#include <gtest/gtest.h>

#include <limits>

#include "../real_literal.h"

namespace impulse::material_test {
namespace {

TEST(Materials, AreTheArticlesTable) {
  struct Expected {
    std::string_view name;
    Real density, restitution;
  };
  const Expected rows[] = {{"Rock", 0.6_r, 0.1_r},       {"Wood", 0.3_r, 0.2_r},       {"Metal", 1.2_r, 0.05_r},
                           {"BouncyBall", 0.3_r, 0.8_r}, {"SuperBall", 0.3_r, 0.95_r}, {"Pillow", 0.1_r, 0.2_r},
                           {"Static", 0.0_r, 0.4_r}};
  ASSERT_EQ(materials().size(), std::size(rows));
  for (std::size_t i = 0; i < std::size(rows); ++i) {
    EXPECT_EQ(materials()[i].name, rows[i].name);
    EXPECT_EQ(materials()[i].material.density, rows[i].density);
    EXPECT_EQ(materials()[i].material.restitution, rows[i].restitution);
  }
}

TEST(Materials, AreFoundByListedNameOrWithDashes) {
  ASSERT_NE(find_material("BouncyBall"), nullptr);
  EXPECT_EQ(find_material("bouncy-ball"), find_material("BouncyBall"));
  EXPECT_EQ(find_material("rock")->density, 0.6_r);
  EXPECT_EQ(find_material("bouncyball"), nullptr);
  EXPECT_EQ(find_material(""), nullptr);
}

TEST(Mix, FollowsEachRule) {
  EXPECT_EQ(mix(FrictionMixing::geometric, 4, 9), 6);
  EXPECT_EQ(mix(FrictionMixing::pythagorean, 3, 4), 5);  // the article's PythagoreanSolve
  EXPECT_EQ(mix(FrictionMixing::average, 1, 2), 1.5_r);
  EXPECT_EQ(mix(FrictionMixing::min, 1, 2), 1);
  EXPECT_EQ(mix(FrictionMixing::max, 1, 2), 2);
  EXPECT_EQ(mix(FrictionMixing::multiply, 2, 3), 6);
  EXPECT_EQ(mix(RestitutionMixing::max, 0.25_r, 0.5_r), 0.5_r);
  EXPECT_EQ(mix(RestitutionMixing::min, 0.25_r, 0.5_r), 0.25_r);
  EXPECT_EQ(mix(RestitutionMixing::average, 0.25_r, 0.5_r), 0.375_r);
  EXPECT_EQ(mix(RestitutionMixing::multiply, 0.25_r, 0.5_r), 0.125_r);
}

}  // namespace
}  // namespace impulse::material_test
