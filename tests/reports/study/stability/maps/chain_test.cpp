#include <gtest/gtest.h>

#include "bracket.h"

namespace plumb {
namespace {

TEST(ChainMap, SeesAChainThatIsTornApart) {
  const Bracket found = bracket("chain", "impulse:solver=article", 10, 1, 10000, "holds");
  EXPECT_EQ(found.seen.fate, Fate::sinks);
}

}  // namespace
}  // namespace plumb
