#include "reports/cli/joined.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "../fakes.h"

namespace plumb::joined_test {
namespace {

using ::testing::HasSubstr;

std::string told_of(const Engine& one) {
  const Engine first = fakes::engine("a");
  const std::vector<const Engine*> all{&first, &one};
  try {
    check_joined(all);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(CheckJoined, TakesTheWholeCatalog) {
  EXPECT_NO_THROW(check_joined(Catalog<Engine>::all()));
  EXPECT_EQ(told_of(fakes::engine("b")), "");
}

TEST(CheckJoined, NamesTheEngineAndWhatItLacks) {
  Engine mine = fakes::engine("mine");
  mine.build = nullptr;
  EXPECT_EQ(told_of(mine), "engine \"mine\" cannot be built: Engine::build is empty");
  mine = fakes::engine("mine");
  mine.unsupported = nullptr;
  EXPECT_THAT(told_of(mine), HasSubstr("Engine::unsupported is empty"));
  mine = fakes::engine("mine");
  mine.stepping = nullptr;
  EXPECT_THAT(told_of(mine), HasSubstr("Engine::stepping is empty"));
}

TEST(CheckJoined, WantsNamesThatTheCommandLineCanTellApart) {
  EXPECT_THAT(told_of(fakes::engine("a")), HasSubstr("\"a\" is there twice"));
  EXPECT_THAT(told_of(fakes::engine("")), HasSubstr("needs a name"));
  EXPECT_THAT(told_of(fakes::engine("my engine")), HasSubstr("without space"));
  EXPECT_THAT(told_of(fakes::engine("mine:2")), HasSubstr("without space"));
}

}  // namespace
}  // namespace plumb::joined_test
