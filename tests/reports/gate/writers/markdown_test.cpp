#include <gmock/gmock.h>

#include <algorithm>

#include "reports/gate/writer.h"
#include "sample.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string markdown(const GateResult& result) { return Catalog<GateWriter>::find("markdown")->text(result); }

TEST(Markdown, HasARowForEveryOffence) {
  const std::string text = markdown(sample_gate_result());
  EXPECT_THAT(text, HasSubstr("### Plumb: NOT as accepted"));
  EXPECT_THAT(text, HasSubstr("| 0.1 J | 0.2 J | 1e-09 off |"));
  EXPECT_THAT(text, HasSubstr("`plumb accept`"));
}

TEST(Markdown, ShowsNamesAsTextAndInOneCell) {
  const std::string text = markdown(sample_gate_result());
  EXPECT_THAT(text, Not(HasSubstr("<")));
  EXPECT_THAT(text, HasSubstr("&#60;img src=x"));
  const auto row = text.find("| worse |");
  const std::string line = text.substr(row, text.find('\n', row) - row);
  EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 8);
}

TEST(Markdown, StaysWithinACommentOnAPullRequest) {
  GateResult many = sample_gate_result();
  many.regressions.assign(10'000, many.regressions[0]);
  const std::string text = markdown(many);
  EXPECT_LT(text.size(), 65'536u);
  EXPECT_THAT(text, HasSubstr("And 9900 more."));
}

TEST(Markdown, IsShortWhereAllIsAsAccepted) {
  EXPECT_EQ(markdown(passed_gate_result()), "### Plumb: as accepted: 1 run, to the bit\n");
}

}  // namespace
}  // namespace plumb
