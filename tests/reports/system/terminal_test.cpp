#include "reports/system/terminal.h"

#include <gtest/gtest.h>

namespace plumb::terminal_test {
namespace {

TEST(LogPace, HasALineInThirtySeconds) {
  LogPace pace(LogPace::interval);
  EXPECT_FALSE(pace.due(0));
  EXPECT_FALSE(pace.due(29));
  EXPECT_TRUE(pace.due(31));
  EXPECT_FALSE(pace.due(60));
  EXPECT_TRUE(pace.due(61));
}

std::string logged(ProgressLine::Kind kind) {
  ::testing::internal::CaptureStderr();
  {
    const ProgressLine line(kind);
    line.show("[0/9] bounce\033[2J");
    line.show("[1/9] slope");
  }
  return ::testing::internal::GetCapturedStderr();
}

TEST(ProgressLine, LogsTheStartAndTheEndOfALongRunOnly) {
  EXPECT_EQ(logged(ProgressLine::Kind::long_run), "[0/9] bounce?[2J\ndone in 0 s\n");
  EXPECT_EQ(logged(ProgressLine::Kind::usual), "");
  EXPECT_EQ(logged(ProgressLine::Kind::quiet), "");
}

}  // namespace
}  // namespace plumb::terminal_test
