#include "reports/system/tool.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(Tool, IsFoundInPathOrNot) {
  ASSERT_TRUE(find_tool("sh"));
  EXPECT_EQ(find_tool("sh")->filename(), "sh");
  EXPECT_FALSE(find_tool("no-such-program-of-anybodys"));
}

TEST(Tool, GivesItsExitCodeOrTheSignalThatEndedIt) {
  EXPECT_EQ(run_tool({"sh", "-c", "exit 3"}), 3);
  EXPECT_EQ(run_tool({"sh", "-c", "kill -9 $$"}), 128 + 9);
  EXPECT_EQ(run_tool({"no-such-program-of-anybodys"}), 127);
}

TEST(Tool, TakesItsWordsAsTheyAre) { EXPECT_EQ(run_tool({"test", "a b; exit 1", "=", "a b; exit 1"}), 0); }

TEST(Tool, SaysWhetherItStarted) {
  EXPECT_TRUE(start_tool({"true"}));
  EXPECT_FALSE(start_tool({"no-such-program-of-anybodys"}));
}

}  // namespace
}  // namespace plumb
