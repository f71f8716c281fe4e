#include "impulse/looks_ahead.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace impulse {
namespace {

TEST(LooksAhead, IsWhatTheSolverDoes) {
  for (const char* solver : {"accurate", "exact", "soft-step", "xpbd"}) {
    EXPECT_TRUE(looks_ahead({.solver = solver})) << solver;
  }
  for (const char* solver : {"article", "block", "sequential-impulse", "split-impulse"}) {
    EXPECT_FALSE(looks_ahead({.solver = solver})) << solver;
  }
  EXPECT_THROW(looks_ahead({.solver = "none"}), std::invalid_argument);
}

}  // namespace
}  // namespace impulse
