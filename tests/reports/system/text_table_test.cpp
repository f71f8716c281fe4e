#include "reports/system/text_table.h"

#include <gtest/gtest.h>

namespace plumb::text_table_test {
namespace {

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

TEST(TextTable, ColoursWithoutTakingColumns) {
  EXPECT_EQ(table_of(80, "\033[31m"), "engine   error  cost\nimpulse    \033[31m0.5\033[0m    12\n  as it is\n");
}

}  // namespace
}  // namespace plumb::text_table_test
