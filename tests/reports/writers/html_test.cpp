#include "reports/writers/html.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include <algorithm>

#include "reports/writers/json.h"
#include "sample.h"
#include "unpacking.h"

namespace plumb::html_test {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view page = "<body><!--plumb-data--></body>";

TEST(FillPage, PutsTheReportAndItsSeriesWhereTheMarkWas) {
  std::string why_not;
  const auto filled = fill_page(page, sample_report(), why_not);
  ASSERT_TRUE(filled);
  const std::string before = R"(<body><script type="application/json" id="plumb-data">)";
  const std::string after = "</script></body>";
  ASSERT_THAT(*filled, ::testing::StartsWith(before));
  ASSERT_THAT(*filled, ::testing::EndsWith(after));
  const Json data = Json::parse(filled->substr(before.size(), filled->size() - before.size() - after.size()));
  EXPECT_EQ(unpacked(data["report"].get<std::string>()), to_json(sample_report()).dump());
  ASSERT_EQ(data["curves"].size(), 1u);
  EXPECT_EQ(data["curves"][0]["scenario"], sample_report().runs[0].scenario);
  const Json series = Json::parse(unpacked(data["curves"][0]["series"].get<std::string>()));
  EXPECT_EQ(series.size(), 2u) << "the run that failed left no trace";
  EXPECT_EQ(data["replays"][0]["runs"].size(), 2u);
}

TEST(FillPage, LetsNoNameBreakOut) {
  std::string why_not;
  const std::string filled = *fill_page(page, sample_report(), why_not);
  EXPECT_THAT(filled, ::testing::Not(::testing::HasSubstr("<script>alert")));
  EXPECT_EQ(filled.find("</script>"), filled.rfind("</script>"));
}

TEST(FillPage, WritesAsciiThatReadsAsItWas) {
  std::string why_not;
  const std::string name = "Painlev\u00e9 \u2191 \U0001f600";
  const std::string filled = *fill_page(page, Json{{"name", name}}, why_not);
  EXPECT_TRUE(std::all_of(filled.begin(), filled.end(), [](char letter) { return letter > 0; }));
  const auto start = filled.find('{');
  EXPECT_EQ(Json::parse(filled.substr(start, filled.find("</script>") - start)).at("name"), name);
}

TEST(FillPage, SaysWhyThereIsNoPage) {
  std::string why_not;
  EXPECT_FALSE(fill_page("", sample_report(), why_not));
  EXPECT_EQ(why_not, "built without Node.js: no page");
  EXPECT_FALSE(fill_page("<body></body>", sample_report(), why_not));
  EXPECT_THAT(why_not, ::testing::HasSubstr("no mark"));
}

}  // namespace
}  // namespace plumb::html_test
