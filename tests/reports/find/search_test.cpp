#include <gmock/gmock.h>
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <set>

#include "../study/study_files.h"
#include "reports/find/finding.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/scene_json.h"

namespace plumb::search_test {
namespace {

using ::testing::HasSubstr;

class Search : public StudyFiles {
 protected:
  std::vector<std::string> words(const std::string& out, std::vector<std::string> more) const {
    std::vector<std::string> all{"find", "--out", at(out), "--seed", "3"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  // Name and contents of every scene that was found.
  std::map<std::string, std::string> found(const std::string& out) const {
    std::map<std::string, std::string> all;
    if (!std::filesystem::exists(at(out + "/found"))) return all;
    for (const auto& file : std::filesystem::directory_iterator(at(out + "/found"))) {
      all[file.path().filename().string()] = text(file.path().string());
    }
    return all;
  }

  const std::vector<std::string> small{"--engine", "fault:gravity-twice",
                                       "--engine", "box2d",
                                       "--kind",   "plane",
                                       "--kind",   "flight",
                                       "--count",  "6",
                                       "--budget", "20"};
};

TEST_F(Search, FindsTheSameToTheByteWithAnyNumberOfJobs) {
  std::vector<std::string> one = small;
  one.insert(one.end(), {"--jobs", "1"});
  std::vector<std::string> two = small;
  two.insert(two.end(), {"--jobs", "2"});
  EXPECT_EQ(say(words("one", one)).code, 0);
  EXPECT_EQ(say(words("two", two)).code, 0);
  EXPECT_FALSE(found("one").empty());
  EXPECT_EQ(found("one"), found("two"));
  EXPECT_EQ(document("one", "find").dump(), document("two", "find").dump());
  EXPECT_EQ(text(at("one/find.md")), text(at("two/find.md")));
  EXPECT_EQ(text(at("one/find.xml")), text(at("two/find.xml")));
}

TEST_F(Search, FindsAPlantedFaultAndCutsItDownToAFewBodies) {
  const Said said = say(words("out", {"--engine", "fault:centre-of-mass", "--kind", "composite", "--count", "6"}));
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, ::testing::StartsWith("Of 6 random scenes, fault:centre-of-mass is wrong in "));
  EXPECT_THAT(said.out, HasSubstr("1 of 1 faults found"));
  auto scenes = found("out");
  std::erase_if(scenes, [](const auto& one) { return one.first.ends_with(image_ending); });
  ASSERT_EQ(scenes.size(), 1U);
  const SceneFile file = read_scene(scenes.begin()->second, scenes.begin()->first);
  const Scene& scene = file.scene;
  const auto moving =
      std::ranges::count_if(scene.bodies, [](const Body& one) { return one.type == BodyType::dynamic; });
  EXPECT_LE(moving, 3);
  EXPECT_EQ(file.origin.value_or(Origin{}).engine, "fault:centre-of-mass");
}

// While it looks, and while it cuts down: 6 scenes, then what is found in them.
TEST_F(Search, GoesOnAfterKill9AsIfNothingHadHappened) {
  ASSERT_EQ(say(words("calm", small)).code, 0);
  const auto lines = [&](const std::string& out) {
    const std::string all = text(at(out + "/study-find.jsonl"));
    return std::count(all.begin(), all.end(), '\n');
  };
  for (const int finished : {3, 8}) {
    const std::string out = "killed" + std::to_string(finished);
    const pid_t process = fork();
    if (process == 0) _exit(program(words(out, small)));
    while (lines(out) < finished) usleep(200);
    kill(process, SIGKILL);
    waitpid(process, nullptr, 0);
    std::vector<std::string> more = small;
    more.push_back("--resume");
    EXPECT_EQ(say(words(out, more)).code, 0);
    EXPECT_EQ(found(out), found("calm"));
    EXPECT_EQ(document(out, "find").dump(), document("calm", "find").dump());
    const auto results = document(out, "find")["results"];
    std::set<std::string> keys;
    for (const auto& result : results) keys.insert(result["key"].get<std::string>());
    EXPECT_EQ(keys.size(), results.size()) << "a job's result was kept twice";
    EXPECT_GT(results.size(), 8U) << "there is nothing to cut down, so nothing was killed while it did";
  }
}

TEST_F(Search, InShardsFindsTheSame) {
  for (const char* shard : {"1/2", "2/2"}) {
    std::vector<std::string> part = small;
    part.insert(part.end(), {"--shard", shard});
    EXPECT_EQ(say(words("parts", part)).code, 0);
  }
  EXPECT_EQ(
      say({"merge", at("parts/study-find-1-of-2.jsonl"), at("parts/study-find-2-of-2.jsonl"), "--out", at("merged")})
          .code,
      0);
  EXPECT_EQ(say(words("whole", small)).code, 0);
  EXPECT_EQ(found("merged"), found("whole"));
  EXPECT_EQ(document("merged", "find").dump(), document("whole", "find").dump());
}

TEST_F(Search, EndsWhenItsTimeIsUpWithWhatItHas) {
  std::vector<std::string> timed = small;
  timed.erase(std::ranges::find(timed, "--count"), std::ranges::find(timed, "--count") + 2);
  timed.insert(timed.end(), {"--time", "1s"});
  const Said said = say(words("out", timed));
  EXPECT_EQ(said.code, 0) << said.err;
  const auto scenes = document("out", "find")["findings"]["scenes"].get<int>();
  EXPECT_GE(scenes, 1);
  EXPECT_LT(scenes, 50'000);
}

TEST_F(Search, RunsACorpusAgainAsAGate) {
  ASSERT_EQ(say(words("out", small)).code, 0);
  const Said broken = say({"find", "--again", at("out/found"), "--out", at("again")});
  EXPECT_EQ(broken.code, 1) << broken.out << broken.err;
  EXPECT_THAT(text(at("again/again.xml")), HasSubstr("<failure message="));
  EXPECT_THAT(text(at("again/again.md")), HasSubstr("fail."));
  const std::string table = text(at("again/again.md"));
  EXPECT_EQ(say({"find", "--again", at("out/found"), "--jobs", "2", "--out", at("again")}).code, 1);
  EXPECT_EQ(text(at("again/again.md")), table) << "with another number of jobs";
  for (const auto& [name, scene] : found("out")) {
    if (!name.starts_with("fault")) std::filesystem::remove(at("out/found/" + name));
  }
  const Said mended = say({"find", "--again", at("out/found"), "--engine", "impulse", "--out", at("again")});
  EXPECT_EQ(mended.code, 0) << mended.out << mended.err;
  EXPECT_THAT(text(at("again/again.xml")), HasSubstr("failures=\"0\""));
}

TEST_F(Search, FailsIfJudgesComplainOfAClosedForm) {
  const Said fine = say(words("fine", {"--engine", "closed-form:all", "--kind", "plane", "--count", "4"}));
  EXPECT_EQ(fine.code, 0) << fine.out << fine.err;
  EXPECT_THAT(fine.out, HasSubstr("No false alarm"));
}

// Of a scene and its image both films are there, and both files.
TEST_F(Search, WritesSceneAndImageOfABrokenRelation) {
  const Said said = say(words("out", {"--engine", "chipmunk", "--kind", "pair", "--count", "8", "--each", "1"}));
  EXPECT_EQ(said.code, 0) << said.err;
  const auto found_here = document("out", "find")["findings"]["found"];
  const auto broken = std::ranges::find_if(
      found_here, [](const auto& one) { return one["reason"].template get<std::string>().starts_with("relation "); });
  ASSERT_NE(broken, found_here.end()) << said.out;
  const std::string image = (*broken)["image"];
  EXPECT_EQ(read_scene(text(at("out/" + image)), image).scene.name, (*broken)["name"].get<std::string>() + ".image");
  const auto results = document("out", "find")["results"];
  const auto job = std::ranges::find_if(results, [&](const auto& one) { return one["key"] == (*broken)["job"]; });
  ASSERT_NE(job, results.end());
  EXPECT_EQ((*job)["values"]["run"]["films"].size(), 2U);
}

TEST_F(Search, SaysWhatIsWrongWithItsOptions) {
  EXPECT_THAT(say(words("out", {"--kind", "towr"})).err, HasSubstr("tower"));
  EXPECT_THAT(say(words("out", {"--engine", "fault:gravity-twce"})).err, HasSubstr("gravity-twice"));
  EXPECT_THAT(say(words("out", {"--time", "soon"})).err, HasSubstr("90s, 10m or 2h"));
  EXPECT_THAT(say({"find", "--again", at("nowhere")}).err, HasSubstr("is not a folder"));
  for (const char* option : {"--time", "--seed", "--kind"}) {
    const Said refused = say({"find", "--again", at("nowhere"), option, option[2] == 'k' ? "heap" : "1"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, HasSubstr(std::string(option) + ": --again runs the scenes of a folder as they are"));
  }
  EXPECT_EQ(say({"find", "--again", at("nowhere")}).code, 2);
}

/// What was found once, run again.
class Corpus : public StudyFiles {
 protected:
  Said again(const std::string& folder) const { return say({"find", "--again", folder, "--out", at("again")}); }
};

TEST_F(Corpus, OfMendedScenesHolds) {
  const Said said = again(PLUMB_SOURCE_DIR "/tests/reference/found");
  EXPECT_EQ(said.code, 0) << said.out << said.err;
}

// Where the library is of another version, or the judges changed, an author must not be sent a scene that holds.
// Engines of npm are run where they are installed.
TEST_F(Corpus, OfOtherEnginesStillShowsWhatIsSaidOfThem) {
  for (const char* engine : {"box2d", "chipmunk"}) {
    if (Catalog<Engine>::find(engine) == nullptr) GTEST_SKIP() << "built without " << engine;
  }
  const std::string folder = PLUMB_SOURCE_DIR "/reference/found";
  const Said said = again(folder);
  EXPECT_EQ(said.code, 1) << said.err;
  EXPECT_THAT(said.out, testing::Not(HasSubstr("holds")));
  EXPECT_THAT(said.out, testing::Not(HasSubstr("not supported")));
}

TEST_F(Corpus, IsJudgedByWhatItsFilesState) {
  std::filesystem::create_directories(at("corpus"));
  for (const char* height : {"-5", "-4"}) {
    put(at("corpus/fall.json"), std::string(R"({"plumb": 1, "name": "fall", "gravity": [0, -10], "duration": 1,
        "bodies": [{"name": "ball", "type": "dynamic", "shapes": [{"type": "circle", "radius": 1}]}],
        "truth": [{"body": "ball", "quantity": "y", "time": 1, "value": )") +
                                    height + R"(, "tolerance": 0.01, "source": "g t^2/2"}]})");
    const Said said = again(at("corpus"));
    const bool right = std::string(height) == "-5";
    EXPECT_EQ(said.code, right ? 0 : 1) << said.out << said.err;
    EXPECT_EQ(said.out.find("is off the stated truth y by 1 m, 100 times what is allowed") == std::string::npos, right)
        << said.out;
  }
}

TEST_F(Corpus, RunsNoSceneOfAnEngineThatIsNotHere) {
  std::filesystem::create_directories(at("corpus"));
  put(at("corpus/one.json"), R"({"plumb": 1, "name": "one", "origin": {"engine": "nowhere"}, "gravity": [0, -10],
      "duration": 0.1, "bodies": [{"name": "ball", "type": "dynamic", "shapes": [{"type": "circle", "radius": 1}]}]})");
  const Said said = again(at("corpus"));
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("not run: "));
  EXPECT_THAT(said.out, HasSubstr("0 of 0 fail."));
  EXPECT_EQ(say({"find", "--again", at("corpus"), "--engine", "nowhere", "--out", at("again")}).code, 2);
}

}  // namespace
}  // namespace plumb::search_test
