#include "reports/system/jobs.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace plumb::jobs_test {
namespace {

TEST(DoAll, CallsEachIndexOnceForAnyNumberOfJobs) {
  for (const int jobs : {1, 2, 7}) {
    std::vector<std::atomic<int>> calls(100);
    do_all(calls.size(), jobs, [&](std::size_t i) { ++calls[i]; });
    for (const auto& count : calls) EXPECT_EQ(count, 1);
  }
}

TEST(DoAll, FinishesAllAndRethrowsTheExceptionOfTheLowestIndex) {
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

TEST(DoAll, CallsNothingForACountOfZero) {
  do_all(0, 4, [](std::size_t) { FAIL(); });
}

}  // namespace
}  // namespace plumb::jobs_test
