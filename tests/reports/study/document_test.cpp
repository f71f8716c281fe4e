#include "reports/study/document.h"

#include <gmock/gmock.h>

namespace plumb {
namespace {

const std::vector<PointResult> results{
    {.key = "a,1", .row = {{{"x", 0.1}, {"word", "says \"no\""}, {"list", {1, 2}}}, {{"median", 2.0}}}},
    {.key = "b", .ending = Ending::crashed, .reason = "signal 6", .row = {{{"y", true}, {"x", nullptr}}, {}}}};

TEST(StudyDocument, IsATableOfAllColumnsThatAnyPointHas) {
  EXPECT_EQ(csv_of(results),
            "key,ending,reason,x,word,y,time_median\n"
            "\"a,1\",done,,0.1,\"says \"\"no\"\"\",,2.0\n"
            "b,crashed,signal 6,,,true,\n");
}

TEST(StudyDocument, KeepsWhatHangsOnTheClockApart) {
  const Study study{.name = "fake", .about = "one"};
  const Findings found{.findings = {{"f", 1}}, .timings = {{"t", 2}}};
  auto json = document_of(study, {.study = "fake", .configuration = {{"c", 3}}}, results, found);
  EXPECT_EQ(json["timings"]["points"]["a,1"]["median"], 2.0);
  EXPECT_EQ(json["timings"]["t"], 2);
  EXPECT_EQ(json["points"][1]["ending"], "crashed");
  json.erase("timings");
  EXPECT_EQ(json.dump().find("median"), std::string::npos);
}

}  // namespace
}  // namespace plumb
