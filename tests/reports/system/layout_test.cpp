#include "reports/system/layout.h"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

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

std::string table_of(std::size_t width, const char* colour = "") {
  TextTable table({{"engine", 0, true}, {"error"}, {"cost", 1}}, 0, width);
  table.add({{"impulse"}, {"0.5", colour}, {"12"}});
  table.add_lines("  as it is\n");
  return table.text();
}

TEST(TextTable, AlignsNumbersToTheRight) {
  EXPECT_EQ(table_of(80), "engine   error  cost\nimpulse    0.5    12\n  as it is\n");
}

TEST(TextTable, LeavesTheLeastImportantColumnOutWhereThereIsNoRoom) {
  EXPECT_EQ(table_of(19), "engine   error\nimpulse    0.5\n  as it is\n");
}

TEST(TextTable, CutsLongNamesOnlyWhereThereIsNoRoom) {
  const std::string name = "impulse:solver=exact,integrator=rk4";
  const auto named = [&](std::size_t width) {
    TextTable table({{"engine", 0, true}, {"error"}}, 0, width);
    table.add({{name}, {"0.5"}});
    return table.text();
  };
  EXPECT_NE(named(80).find(name), std::string::npos);
  EXPECT_NE(named(40).find("\nimpulse:solver=exact,in..."), std::string::npos) << named(40);
}

TEST(Enumerated, HasAnAndBeforeTheLast) {
  const std::vector<std::string> all{"a", "b", "c"};
  EXPECT_EQ(enumerated(std::span(all).first(0)), "");
  EXPECT_EQ(enumerated(std::span(all).first(1)), "a");
  EXPECT_EQ(enumerated(std::span(all).first(2)), "a and b");
  EXPECT_EQ(enumerated(all), "a, b and c");
}

TEST(TextTable, ColoursWithoutTakingColumns) {
  EXPECT_EQ(table_of(80, "\033[31m"), "engine   error  cost\nimpulse    \033[31m0.5\033[0m    12\n  as it is\n");
}

}  // namespace
}  // namespace plumb::layout_test
