#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <vector>

#include "../../../reference/programs/faults.h"
#include "scene_files.h"

namespace plumb::report_test {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

class ReportCommand : public SceneFiles {
 protected:
  // One disc, which is all that faulty.sh answers for.
  std::string one_disc() const {
    return put("disc.json",
               R"({"plumb": 1, "name": "disc", "about": "A disc floats.", "gravity": [0, 0], "duration": 0.5,
                   "bodies": [{"name": "disc", "type": "dynamic", "position": [0, 5], "shapes": [{"type": "circle", "radius": 0.5}]}]})");
  }

  static Json entry(const Json& list, const std::string& key, const std::string& value) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const Json& one) { return one.at(key) == value; });
    return found == list.end() ? Json(nullptr) : *found;
  }
};

TEST_F(ReportCommand, NamesEngineCaseAndCauseOfEveryFailureAndWritesAllElse) {
  std::vector<std::string> words{"report", one_disc(), "--no-studies", "--out",  at("out"),
                                 "--jobs", "1",        "--engine",     "impulse"};
  for (const ProgramFault& fault : program_faults) {
    const std::string word = faulty_program(PLUMB_SOURCE_DIR, fault.name) + ":timeout=" + fault.timeout;
    words.insert(words.end(), {"--engine", word});
  }
  const Said said = say(words);
  ASSERT_EQ(said.code, 0) << said.err;
  const Json report = json(at("out/report.json"));
  EXPECT_EQ(entry(report["runs"], "engine", "impulse").at("status"), "ok");
  for (const ProgramFault& fault : program_faults) {
    const Json engine = entry(report["engines"], "word", faulty_program(PLUMB_SOURCE_DIR, fault.name));
    ASSERT_FALSE(engine.is_null()) << fault.name;
    const Json run = entry(report["runs"], "engine", engine.at("name"));
    EXPECT_EQ(run.at("status"), "failed") << fault.name;
    EXPECT_EQ(run.at("scenario"), "disc") << fault.name;
    EXPECT_THAT(run.at("reason").get<std::string>(), HasSubstr(fault.reason)) << fault.name;
  }
  EXPECT_THAT(said.out, ContainsRegex("faulty@1#[0-9]+ is exec:sh ")) << "several bear one name";
  for (const char* file : {"out/report.md", "out/report.csv", "out/report.xml"}) {
    EXPECT_TRUE(std::filesystem::exists(at(file))) << file;
  }
}

}  // namespace
}  // namespace plumb::report_test
