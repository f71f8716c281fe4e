#include "reports/prove/variation.h"

#include <gtest/gtest.h>

#include <set>

#include "reports/run/selection.h"

namespace plumb {
namespace {

TEST(Variation, ChangesNoParameterButASeed) {
  bool seeded = false;
  for (const Case& one : default_cases(true)) {
    const Case varied = variation_of(7).of(one);
    for (const Parameter& parameter : one.scenario->parameters) {
      const double was = one.parameters.at(parameter.name);
      const double is = varied.parameters.at(parameter.name);
      if (parameter.name == "seed") {
        EXPECT_EQ(is, parameter.min + 7) << one.scenario->name;
        seeded = true;
      } else {
        EXPECT_EQ(is, was) << one.scenario->name;
      }
    }
  }
  EXPECT_TRUE(seeded);
}

TEST(Variation, IsTheSameForTheSameSeedAndOfManyKinds) {
  std::set<std::string> kinds;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_EQ(variation_of(seed).words(), variation_of(seed).words());
    kinds.insert(variation_of(seed).words());
  }
  EXPECT_EQ(kinds.size(), 20U) << "the seed is in the words";
}

}  // namespace
}  // namespace plumb
