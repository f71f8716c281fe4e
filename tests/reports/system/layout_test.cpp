#include "reports/system/layout.h"

#include <gtest/gtest.h>

namespace plumb::layout_test {
namespace {

TEST(Layout, NeverSeparatesANumberFromItsUnitAndTolerance) {
  EXPECT_EQ(wrapped("the speed of the box is 0.41 +- 0.05 m/s now", 0, 36),
            "the speed of the box is\n0.41 +- 0.05 m/s now\n");
  EXPECT_EQ(wrapped("and momentum by as much as 12.5 % of scale", 2, 34),
            "  and momentum by as much as\n  12.5 % of scale\n");
}

TEST(Layout, BreaksWordsThatAreLongerThanALine) {
  EXPECT_EQ(wrapped("a234567890b234567890c234567890d2345", 0, 30), "a234567890b234567890c234567890\nd2345\n");
}

TEST(Layout, CountsLettersNotBytes) {
  EXPECT_EQ(columns_of("L\u00d6VE"), 4u);
  EXPECT_EQ(cut("L\u00d6VE and others", 7), "L\u00d6VE...");
  EXPECT_EQ(cut("L\u00d6VE", 4), "L\u00d6VE");
}

TEST(Layout, PutsTextBesideANameOrBelowALongOne) {
  EXPECT_EQ(beside("name", 8, "text", 40), "name    text\n");
  EXPECT_EQ(beside("a long name", 8, "text", 40), "a long name\n        text\n");
}

}  // namespace
}  // namespace plumb::layout_test
