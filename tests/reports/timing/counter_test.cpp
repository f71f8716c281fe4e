#include "reports/timing/counter.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(InstructionCounter, CountsOrSaysWhyNot) {
  const InstructionCounter counter;
  const auto before = counter.count();
  EXPECT_EQ(before.has_value(), counter.missing().empty()) << counter.missing();
  volatile unsigned sum = 0;
  for (unsigned i = 0; i < 100000; ++i) sum = sum + i;
  if (!before) return;
  EXPECT_GE(*counter.count(), *before + 100000);
}

}  // namespace
}  // namespace plumb
