#include "reports/study/document.h"

#include <gmock/gmock.h>

namespace plumb {
namespace {

const std::vector<JobResult> results{
    {.key = "a,1", .output = {{{"x", 0.1}, {"word", "contains \"no\""}, {"list", {1, 2}}}, {{"median", 2.0}}}},
    {.key = "b", .ending = Ending::crashed, .reason = "signal 6", .output = {{{"y", true}, {"x", nullptr}}, {}}}};

TEST(StudyDocument, IsATableOfAllColumnsThatAnyResultHas) {
  EXPECT_EQ(csv_of(results),
            "key,ending,reason,x,word,y,time_median\n"
            "\"a,1\",done,,0.1,\"contains \"\"no\"\"\",,2.0\n"
            "b,crashed,signal 6,,,true,\n");
}

TEST(StudyDocument, SeparatesWhatDependsOnTheClock) {
  const Study study{.name = "fake", .about = "one"};
  const Findings found{.findings = {{"f", 1}}, .timings = {{"t", 2}}};
  auto json = document_of(study, {.study = "fake", .configuration = {{"c", 3}}}, results, found);
  EXPECT_EQ(json["timings"]["results"]["a,1"]["median"], 2.0);
  EXPECT_EQ(json["timings"]["t"], 2);
  EXPECT_EQ(json["results"][1]["ending"], "crashed");
  json.erase("timings");
  EXPECT_EQ(json.dump().find("median"), std::string::npos);
}

}  // namespace
}  // namespace plumb
