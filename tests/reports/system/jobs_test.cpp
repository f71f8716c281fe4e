#include "reports/system/jobs.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace plumb {
namespace {

TEST(DoAll, DoesEachPieceOnceWithAnyNumberOfJobs) {
  for (const int jobs : {1, 2, 7}) {
    std::vector<std::atomic<int>> times(100);
    do_all(times.size(), jobs, [&](std::size_t i) { ++times[i]; });
    for (const auto& one : times) EXPECT_EQ(one, 1);
  }
}

TEST(DoAll, FinishesTheRestAndThrowsWhatTheFirstInOrderThrew) {
  std::atomic<int> done = 0;
  const auto work = [&](std::size_t i) {
    ++done;
    if (i == 3 || i == 8) throw std::runtime_error(i == 3 ? "three" : "eight");
  };
  try {
    do_all(20, 2, work);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "three");
  }
  EXPECT_EQ(done, 20);
}

TEST(DoAll, HasNothingToDoForNothing) {
  do_all(0, 4, [](std::size_t) { FAIL(); });
}

}  // namespace
}  // namespace plumb
