#include "reference/programs/protocol.h"

#include <gmock/gmock.h>

#include <cmath>
#include <string>

namespace plumb::step_line_test {
namespace {

using protocol::scan_step_line;
using protocol::StepLine;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(StepLine, ReadsKeysInAnyOrderAndWhiteSpace) {
  StepLine read;
  ASSERT_TRUE(scan_step_line(R"({ "ns": 7, "states": [[1, -2.5, 0.1, 1e-3, 4E2, -0]], "step": 3 })", read));
  EXPECT_EQ(read.step, 3u);
  EXPECT_EQ(read.nanoseconds, 7);
  EXPECT_THAT(read.states, ElementsAre(1, -2.5, 0.1, 1e-3, 400, 0));
  EXPECT_TRUE(std::signbit(read.states.back()));
  EXPECT_THAT(read.contacts, IsEmpty());
}

TEST(StepLine, ReadsWhatPlumbWrites) {
  const BodyState state{{1.0 / 3, 2}, 3, {4, 5e-324}, -0x1p-53};
  const ContactState contact{.a = 0, .b = 1, .point = {1, 2}, .normal = {0, 1}, .normal_impulse = 0.1};
  const std::string line = protocol::write_step(12, 345, std::span(&state, 1), std::span(&contact, 1));
  StepLine read;
  ASSERT_TRUE(scan_step_line(line, read));
  EXPECT_EQ(read.step, 12u);
  EXPECT_EQ(read.nanoseconds, 345);
  EXPECT_THAT(read.states, ElementsAre(1.0 / 3, 2, 3, 4, 5e-324, -0x1p-53));
  EXPECT_THAT(read.contacts, ElementsAre(0, 1, 1, 2, 0, 1, 0.1, 0, 0));
}

// What JSON or the protocol does not know is left to the parser, which says what is wrong.
TEST(StepLine, LeavesAnythingElse) {
  const auto with = [](const std::string& number) {
    return R"({"step":1,"ns":1,"states":[[0,0,0,0,0,)" + number + "]]}";
  };
  StepLine read;
  ASSERT_TRUE(scan_step_line(with("1.5"), read));
  for (const char* number : {"NaN", "inf", "-inf", "1e999", "01", "-01", ".5", "1.", "1.e3", "+1", "0x1", "1e", "\"1\"",
                             "null", "", "1,1", "1]"}) {
    EXPECT_FALSE(scan_step_line(with(number), read)) << number;
  }
  for (const char* line :
       {"", "{", "{}", "[]", R"({"error":"why"})", R"({"step":1,"ns":1})", R"({"step":1.5,"ns":1,"states":[]})",
        R"({"step":-1,"ns":1,"states":[]})", R"({"step":1,"ns":-1,"states":[]})", R"({"step":1,"ns":1,"states":[]}})",
        R"({"step":1,"ns":1,"states":[],"ns":1})", R"({"step":1,"ns":1,"states":[],"more":1})",
        R"({"step":1,"ns":1,"states":[],})", R"({"step":1,"ns":1,"states":"AAAA"})",
        R"({"st\u0065p":1,"ns":1,"states":[]})"}) {
    EXPECT_FALSE(scan_step_line(line, read)) << line;
  }
}

TEST(StepsAhead, AreManyOnlyWhileTheyAreSoonAnswered) {
  protocol::StepsAhead ahead;
  const std::size_t first = ahead.count();
  ahead.took(1, 0);
  EXPECT_EQ(ahead.count(), first) << "one step says nothing of many";
  ahead.took(first, 0);
  EXPECT_EQ(ahead.count(), 2 * first);
  for (int i = 0; i < 20; ++i) ahead.took(ahead.count(), 0);
  EXPECT_LE(ahead.count(), 1000u);
  ahead.took(ahead.count(), 1);
  EXPECT_EQ(ahead.count(), first);
}

}  // namespace
}  // namespace plumb::step_line_test
