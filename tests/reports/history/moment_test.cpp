#include "reports/history/moment.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace plumb {
namespace {

TEST(Moment, IsGivenInUtc) {
  EXPECT_EQ(utc("2026-11-21"), "2026-11-21T00:00:00Z");
  EXPECT_EQ(utc("2026-11-21T09:06:10Z"), "2026-11-21T09:06:10Z");
  EXPECT_EQ(utc("2026-11-21T10:06:10+01:00"), "2026-11-21T09:06:10Z");
  EXPECT_EQ(utc("2024-02-28T22:30:00-05:30"), "2024-02-29T04:00:00Z");
  EXPECT_EQ(utc("2026-01-01T00:30:00+01:00"), "2025-12-31T23:30:00Z");
}

TEST(Moment, RefusesWhatIsNone) {
  for (const char* text : {"", "now", "2026-13-01", "2026-02-29", "2026-11-21T09:06:10", "2026-11-21T24:00:00Z",
                           "2026-11-21T09:06:10+0100", "2026-11-21 09:06:10Z", "20261121", "2026-1-1"}) {
    EXPECT_THROW(utc(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace plumb
