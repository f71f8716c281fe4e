#include "reports/gate/changes.h"

#include <gmock/gmock.h>

#include "../cli/commands/scene_files.h"
#include "../writers/sample.h"
#include "reports/gate/baseline_json.h"

namespace plumb {
namespace {

using Changes = SceneFiles;

TEST_F(Changes, AreNoneWhereAllIsAsAccepted) {
  const std::string file = put("canonical.json", to_text(baseline_of(sample_report())));
  const auto changes = changes_since(file, sample_report());
  ASSERT_TRUE(changes);
  EXPECT_EQ((*changes)["configuration"]["baseline"], "canonical.json");
  const auto& found = (*changes)["findings"];
  EXPECT_EQ(found["runs"], 3);
  EXPECT_TRUE(found["regressions"].empty()) << found.dump(1);
}

TEST_F(Changes, NameTheRunAndWhatItWas) {
  const std::string file = put("canonical.json", to_text(baseline_of(sample_report())));
  Report report = sample_report();
  report.runs[0].verdict = Verdict::wrong;
  const auto regressions = changes_since(file, report).value()["findings"]["regressions"];
  ASSERT_FALSE(regressions.empty());
  EXPECT_EQ(regressions[0]["scenario"], "slide");
  EXPECT_EQ(regressions[0]["before"], "right");
  EXPECT_EQ(regressions[0]["now"], "wrong");
  EXPECT_EQ(regressions[0]["change"], "worse");
}

TEST_F(Changes, LeaveOutRunsThatOnlyOneOfTheTwoHas) {
  Report before = sample_report();
  before.runs[0].scenario = "gone";
  const std::string file = put("canonical.json", to_text(baseline_of(before)));
  const auto found = changes_since(file, sample_report()).value()["findings"];
  EXPECT_EQ(found["runs"], 2);
  EXPECT_TRUE(found["regressions"].empty()) << found.dump(1);
}

TEST_F(Changes, AreNothingWithoutABaselineOrWithAnotherStep) {
  EXPECT_FALSE(changes_since(at("none.json"), sample_report()));
  Report before = sample_report();
  for (RunRecord& run : before.runs) run.dt = 1.0 / 120;
  EXPECT_FALSE(changes_since(put("other.json", to_text(baseline_of(before))), sample_report()));
}

TEST_F(Changes, AreRefusedFromADamagedBaseline) {
  EXPECT_THROW(changes_since(put("damaged.json", "{"), sample_report()), std::invalid_argument);
}

}  // namespace
}  // namespace plumb
