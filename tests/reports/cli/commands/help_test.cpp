#include <gmock/gmock.h>

#include "../../saying.h"

namespace plumb::help_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(Help, ShowsTheSameAsTheOptionHelp) {
  EXPECT_EQ(say({"help", "run"}).out, say({"run", "--help"}).out);
  EXPECT_EQ(say({"help", "study", "speed"}).out, say({"study", "speed", "--help"}).out);
  EXPECT_THAT(say({"help"}).out, HasSubstr(say({"--help"}).out));
}

TEST(Help, ExplainsEveryWordOfAReport) {
  EXPECT_THAT(say({"help", "coarse"}).out, HasSubstr("within its tolerance, but farther off than 1 %"));
  EXPECT_THAT(say({"help", "error", "/", "scale"}).out, HasSubstr("the same ruler for every engine"));
  EXPECT_THAT(say({"help", "bounce"}).out, HasSubstr("restitution"));
  EXPECT_THAT(say({"help", "impulse"}).out, HasSubstr("solver="));
  EXPECT_THAT(say({"help", "penetration_max"}).out, HasSubstr("metric"));
  EXPECT_THAT(say({"help", "mirror"}).out, HasSubstr("relation"));
  EXPECT_THAT(say({"help", "free_motion"}).out, HasSubstr("invariant"));
}

TEST(Help, SuggestsTheNearestWord) {
  const Said said = say({"help", "tolerence"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("did you mean \"tolerance\"?"));
}

// With no engine of npm installed.
TEST(Show, SaysHowToInstallAnEngineOfNpm) {
  setenv("XDG_DATA_HOME", (::testing::TempDir() + "/no-engines").c_str(), 1);
  for (const char* command : {"show", "help"}) {
    const Said said = say({command, "rapier"});
    EXPECT_EQ(said.code, 0) << said.err;
    EXPECT_THAT(said.out, AllOf(HasSubstr("Rapier"), HasSubstr("not installed: plumb engine add rapier"))) << command;
  }
  EXPECT_THAT(say({"completion", "bash"}).out,
              HasSubstr("'engine add') words='--help --prefix box2d3 matter planck rapier'"));
}

TEST(Show, HasAScenariosQuestionParametersAndAnswer) {
  const Said said = say({"show", "slope"});
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.out, AllOf(HasSubstr("Does a box on a slope stick"), HasSubstr("20 deg, from 0 to 80: of the slope"),
                              HasSubstr("friction=0.5"), HasSubstr("closed form slide")));
  EXPECT_THAT(say({"show", "impulse"}).out, HasSubstr("integrator="));
  EXPECT_THAT(say({"show", "chipmunk"}).out, HasSubstr("what it does differently\n-  positions move first"));
  EXPECT_EQ(say({"show", "slop"}).code, 2);
}

}  // namespace
}  // namespace plumb::help_test
