#include "reports/study/brief.h"

#include <gmock/gmock.h>

#include <memory>
#include <stdexcept>

#include "scenarios/catalog.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

/// Squares some numbers, and adds them up.
Study squares() {
  return {.name = "squares",
          .about = "What squares come to",
          .examples = "",
          .attach = [](CLI::App& app) -> std::function<Json()> {
            const auto numbers = std::make_shared<std::vector<int>>(std::vector<int>{1, 2, 3, 4});
            app.add_option("--numbers", *numbers);
            return [numbers] { return Json{{"numbers", *numbers}}; };
          },
          .plan = [](const Json& configuration) -> StudyPlan {
            std::vector<Point> points;
            for (const int number : configuration.at("numbers")) {
              points.push_back({.key = std::to_string(number), .run = [number] {
                                  Row row;
                                  row.values["square"] = number * number;
                                  return row;
                                }});
            }
            return {points, [](const std::vector<PointResult>& results) {
                      int sum = 0;
                      for (const PointResult& result : results) sum += result.row.values.at("square").get<int>();
                      Findings found;
                      found.findings["sum"] = sum;
                      return found;
                    }};
          },
          .brief = {{"--numbers", "2", "3"}}};
}

TEST(BriefStudy, CarriesOutTheShortFormAndTellsOfEachPoint) {
  std::vector<std::string> told;
  const Json document = brief_document(squares(), 1, [&](const std::string& key, std::size_t done, std::size_t of) {
    told.push_back(key + " " + std::to_string(done) + "/" + std::to_string(of));
  });
  EXPECT_THAT(told, testing::ElementsAre("2 1/2", "3 2/2"));
  EXPECT_EQ(document.at("study"), "squares");
  EXPECT_EQ(document.at("command"), "plumb study squares --numbers 2 3");
  EXPECT_EQ(document.at("configuration").at("numbers"), Json({2, 3}));
  EXPECT_EQ(document.at("findings").at("sum"), 13);
  EXPECT_EQ(document.at("points").size(), 2U);
}

TEST(BriefStudy, HasOnlyOptionsThatTheStudyKnows) {
  Study study = squares();
  study.brief = {{"--nombres", "2"}};
  EXPECT_THROW(brief_document(study, 1, [](const std::string&, std::size_t, std::size_t) {}), std::logic_error);
}

TEST(BriefStudy, OfEveryStudyHasOptionsThatItKnows) {
  for (const Study* study : Catalog<Study>::all()) {
    if (!study->brief) continue;
    CLI::App app;
    const auto configuration = study->attach(app);  // holds what the options write to
    std::vector<std::string> words(study->brief->rbegin(), study->brief->rend());
    EXPECT_NO_THROW(app.parse(words)) << study->name;
  }
}

}  // namespace
}  // namespace plumb
