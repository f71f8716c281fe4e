#include "reports/system/processes.h"

#include <gtest/gtest.h>

namespace plumb::processes_test {
namespace {

TEST(FindProgram, SearchesPath) {
  ASSERT_TRUE(find_program("sh"));
  EXPECT_EQ(find_program("sh")->filename(), "sh");
  EXPECT_FALSE(find_program("no-such-program-of-anybodys"));
}

TEST(RunProgram, ReturnsTheExitCodeOrTheSignal) {
  EXPECT_EQ(run_program({"sh", "-c", "exit 3"}), 3);
  EXPECT_EQ(run_program({"sh", "-c", "kill -9 $$"}), 128 + 9);
  EXPECT_EQ(run_program({"no-such-program-of-anybodys"}), 127);
}

TEST(RunProgram, PassesArgumentsUnchanged) { EXPECT_EQ(run_program({"test", "a b; exit 1", "=", "a b; exit 1"}), 0); }

TEST(OutputOf, IsStandardOutputWithoutTheLastLineBreak) {
  EXPECT_EQ(output_of({"sh", "-c", "echo one; echo two; echo lost >&2"}), "one\ntwo");
  EXPECT_EQ(output_of({"true"}), "");
}

TEST(OutputOf, IsNothingIfTheProgramFails) {
  EXPECT_FALSE(output_of({"sh", "-c", "echo one; exit 1"}));
  EXPECT_FALSE(output_of({"no-such-program-of-anybodys"}));
}

TEST(StartProgram, ReturnsWhetherItStarted) {
  EXPECT_TRUE(start_program({"true"}));
  EXPECT_FALSE(start_program({"no-such-program-of-anybodys"}));
}

}  // namespace
}  // namespace plumb::processes_test
