#include <gmock/gmock.h>

#include <filesystem>
#include <sstream>

#include "../../../reference/programs/faults.h"
#include "scene_files.h"

namespace plumb::check_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class CheckAndAccept : public SceneFiles {
 protected:
  Said accept(const std::string& file) const {
    return say({"accept", "spinning-obb:free-fall", "slope:steep", "--engine", "impulse", "--baseline", file});
  }
  static std::string text(const std::string& path) {
    std::ostringstream all;
    all << std::ifstream(path).rdbuf();
    return all.str();
  }
  // The same with one number another.
  std::string tampered(const std::string& file) const {
    auto baseline = json(file);
    baseline["runs"][0]["numbers"]["energy_drift"]["value"] = 0.123;
    return put("tampered.json", baseline.dump());
  }
};

TEST_F(CheckAndAccept, PassesWhatWasJustAccepted) {
  const Said accepted = accept(at("base.json"));
  EXPECT_EQ(accepted.code, 0) << accepted.err;
  EXPECT_THAT(accepted.out, StartsWith("new baseline: 4 runs\n"));
  const Said checked = say({"check", "--baseline", at("base.json")});
  EXPECT_EQ(checked.code, 0) << checked.out << checked.err;
  EXPECT_EQ(checked.out, "as accepted: 4 runs, to the bit\n");
  const std::string before = text(at("base.json"));
  EXPECT_THAT(say({"accept", "--baseline", at("base.json")}).out, StartsWith("as accepted: 4 runs, to the bit\n"));
  EXPECT_EQ(text(at("base.json")), before) << "the same bytes";
}

TEST_F(CheckAndAccept, NamesProgramsAsTheyWereNamed) {
  const std::string word = faulty_program(PLUMB_SOURCE_DIR, "none") + ":knob=2";
  const Said accepted = say({"accept", "spinning-obb:free-fall", "--engine", word, "--baseline", at("base.json")});
  EXPECT_EQ(accepted.code, 0) << accepted.err;
  const Said checked = say({"check", "--baseline", at("base.json")});
  EXPECT_EQ(checked.code, 0) << checked.out << checked.err;
  EXPECT_THAT(checked.out, StartsWith("as accepted: 2 runs"));
}

TEST_F(CheckAndAccept, AcceptsThatAnEngineFails) {
  for (const char* fault : {"states-nonsense", "crashes-when-asked-how"}) {
    const Said accepted = say({"accept", "spinning-obb:free-fall", "--engine", faulty_program(PLUMB_SOURCE_DIR, fault),
                               "--engine", "impulse", "--baseline", at("base.json")});
    EXPECT_EQ(accepted.code, 0) << fault << ": " << accepted.err;
    EXPECT_EQ(say({"check", "--baseline", at("base.json")}).code, 0) << fault;
    fs::remove(at("base.json"));
  }
}

TEST_F(CheckAndAccept, PrintsJsonOrNothingIfAsked) {
  accept(at("base.json"));
  const std::string file = tampered(at("base.json"));
  const Said said = say({"check", "--baseline", file, "--json", "-"});
  EXPECT_EQ(said.code, 1);
  EXPECT_FALSE(nlohmann::ordered_json::parse(said.out)["regressions"].empty());
  EXPECT_EQ(say({"check", "--baseline", file, "--quiet"}).out, "");
}

TEST_F(CheckAndAccept, KeepsABaselineThatIsASymbolicLink) {
  accept(at("base.json"));
  fs::create_symlink("base.json", at("link.json"));
  EXPECT_EQ(say({"accept", "--baseline", at("link.json")}).code, 0);
  EXPECT_TRUE(fs::is_symlink(at("link.json")));
}

TEST_F(CheckAndAccept, ChecksSomeOfABaseline) {
  accept(at("base.json"));
  const Said some = say({"check", "slope:steep", "--engine", "impulse", "--baseline", at("base.json")});
  EXPECT_EQ(some.out, "as accepted: 2 runs, to the bit\n") << some.err;
  EXPECT_EQ(say({"check", "spring", "--baseline", at("base.json")}).code, 2);
  const Said engine = say({"check", "--engine", "box2d", "--baseline", at("base.json")});
  EXPECT_EQ(engine.code, 2);
  EXPECT_THAT(engine.err, HasSubstr("box2d is not in the baseline; plumb accept"));
}

TEST_F(CheckAndAccept, ExitsWith1AndSaysWhatIsNotAsAccepted) {
  accept(at("base.json"));
  const std::string file = tampered(at("base.json"));
  const Said said =
      say({"check", "--baseline", file, "--junit", at("j.xml"), "--markdown", at("m.md"), "--text", at("t.txt")});
  EXPECT_EQ(said.code, 1);
  EXPECT_THAT(said.out, StartsWith("NOT as accepted: 1 of 4 runs differ"));
  EXPECT_THAT(said.out, HasSubstr("energy_drift: 0.123, now "));
  EXPECT_THAT(text(at("j.xml")), HasSubstr("failures=\"1\""));
  EXPECT_THAT(text(at("m.md")), HasSubstr("### Plumb: NOT as accepted"));
  EXPECT_THAT(text(at("t.txt")), StartsWith("NOT as accepted"));

  const Said accepted = say({"accept", "--baseline", file});
  EXPECT_EQ(accepted.code, 0);
  EXPECT_THAT(accepted.out, HasSubstr("energy_drift: 0.123, now "));
  EXPECT_EQ(text(file), text(at("base.json")));
}

TEST_F(CheckAndAccept, FailsACaseThatIsNoLongerSupported) {
  accept(at("base.json"));
  auto refused = json(at("base.json"));
  for (auto& run : refused["runs"]) {
    if (run["exact"]) continue;
    run["verdict"] = "not supported";
    run["bits"] = "";
    run["numbers"] = nlohmann::json::object();
  }
  const std::string file = put("refused.json", refused.dump());
  const Said said = say({"check", "--against", at("base.json"), file});
  EXPECT_EQ(said.code, 1);
  EXPECT_THAT(said.out, HasSubstr("verdict: right, now not supported"));
}

TEST_F(CheckAndAccept, TakesNamesOrTheCanonicalScenariosButNotBoth) {
  EXPECT_EQ(say({"check", "bounce", "--canonical", "--baseline", at("base.json")}).code, 2);
  const Said own = say({"accept", "--canonical"});
  EXPECT_EQ(own.code, 2);
  EXPECT_THAT(own.err, HasSubstr("needs its own file"));
}

TEST_F(CheckAndAccept, ChecksTheCanonicalScenariosOfABaseline) {
  accept(at("base.json"));
  const Said said = say({"check", "--canonical", "--baseline", at("base.json")});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("is not in the baseline; plumb accept"));
}

TEST_F(CheckAndAccept, ComparesTwoResultsWithoutARun) {
  accept(at("base.json"));
  const std::string other = tampered(at("base.json"));
  EXPECT_EQ(say({"check", "--against", at("base.json"), at("base.json")}).code, 0);
  EXPECT_EQ(say({"check", "--against", at("base.json"), other}).code, 1);
}

TEST_F(CheckAndAccept, ComparesWithAReport) {
  say({"run", "spinning-obb:free-fall", "--engine", "impulse", "--ensemble", "0", "--out", at("out")});
  const Said same = say({"check", "--against", at("out/report.json")});
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  EXPECT_EQ(say({"check", "--against", at("out/report.json"), at("out/report.json")}).code, 0);
}

TEST_F(CheckAndAccept, ExitsWith2WhereThereIsNothingToCompareWith) {
  const Said none = say({"check", "--baseline", at("none.json")});
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("none.json: there is no baseline; `plumb accept` makes one"));
  const Said damaged = say({"check", "--baseline", put("damaged.json", "{\"plumb_baseline\": 1,")});
  EXPECT_EQ(damaged.code, 2);
  EXPECT_THAT(damaged.err, HasSubstr("damaged.json: line 1"));
  EXPECT_EQ(say({"check", "--against", at("none.json"), at("none.json")}).code, 2);
}

TEST_F(CheckAndAccept, LeavesWhatIsNoBaselineAsItIs) {
  const std::string foreign = put("mine.json", "{\"mine\": true}");
  EXPECT_EQ(accept(foreign).code, 2);
  EXPECT_EQ(text(foreign), "{\"mine\": true}");
  EXPECT_EQ(say({"accept", "bounce"}).code, 2) << "some scenarios for the baseline of a set";
  EXPECT_EQ(accept(at("no/such/folder.json")).code, 2);
  EXPECT_FALSE(fs::exists(at("no")));
}

}  // namespace
}  // namespace plumb::check_test
