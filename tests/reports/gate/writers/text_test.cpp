#include <gmock/gmock.h>

#include "reports/gate/writer.h"
#include "sample.h"

namespace plumb {
namespace {

TEST(GateText, BeginsWithTheVerdictAndGoesOnWithTheWorst) {
  EXPECT_EQ(text_of(sample_gate_result(), 1),
            "NOT as accepted: 1 of 2 runs differ (1 worse, 1 changed)\n"
            "  worse: <img src=x onerror=alert(1)> a|b & \"c\" 'd' `e`??, box2d:x=1: verdict: right, now wrong; ]]> "
            "<b>diverged</b>\n"
            "  and 1 more\n"
            "Another platform (libm: this, was <that>).\n");
}

TEST(GateText, IsOneLineWhereAllIsAsAccepted) {
  EXPECT_EQ(text_of(passed_gate_result(), 10), "as accepted: 1 run, to the bit\n");
}

TEST(GateText, SaysWhatWasAllowed) {
  EXPECT_THAT(in_words(sample_gate_result().regressions[1]),
              ::testing::HasSubstr("energy_drift: 0.1 J, now 0.2 J, allowed 1e-09 off; 1e+08 times"));
}

}  // namespace
}  // namespace plumb
