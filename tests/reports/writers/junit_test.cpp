#include "reports/writers/junit.h"

#include <gmock/gmock.h>

#include "reports/writers/output.h"
#include "sample.h"
#include "scenarios/catalog.h"

namespace plumb::junit_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Junit, HasACaseForEachEngineInEachScene) {
  std::string why_not;
  const std::string text = *Catalog<Writer>::find("junit")->text(sample_report(), why_not);
  EXPECT_THAT(text, HasSubstr("<testsuite name=\"plumb\" tests=\"2\" failures=\"2\""));
  EXPECT_THAT(text, HasSubstr("classname=\"slide:on ice\" name=\"an engine with a rather long name"));
  EXPECT_THAT(text, HasSubstr("breaks push of box, &quot;the&quot; first - ground at 1.5 s"));
  EXPECT_THAT(text, HasSubstr("diverged at t = 1 s"));
  EXPECT_THAT(text, Not(HasSubstr("name=\"sliding\""))) << "closed forms are not on trial";
}

TEST(Junit, SaysHowFarOffACheckIsByBothRulers) {
  Report report = sample_report();
  report.runs[1].truth = {{.quantity = "y",
                           .unit = "m",
                           .time = 2,
                           .expected = 1,
                           .measured = 1.5,
                           .error = 0.5,
                           .tolerance = 0.1,
                           .scale = 4}};
  std::string why_not;
  EXPECT_THAT(*Catalog<Writer>::find("junit")->text(report, why_not),
              HasSubstr("y at 2 s: 1.5, expected 1 +- 0.1 m, off by 12.5 % of scale"));
}

TEST(Junit, PassesWhatHoldsAndSkipsWhatDidNotRun) {
  const std::vector<TestCase> cases{{"s", "a", ""}, {"s", "b", "", "has no joints"}, {"s", "c", "is off"}};
  const std::string text = junit("name", cases);
  EXPECT_THAT(text, HasSubstr("tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"1\""));
  EXPECT_THAT(text, HasSubstr("name=\"a\" time=\"0\"/>"));
  EXPECT_THAT(text, HasSubstr("<skipped message=\"has no joints\"/>"));
  EXPECT_THAT(text, HasSubstr("<failure message=\"is off\"/>"));
}

}  // namespace
}  // namespace plumb::junit_test
