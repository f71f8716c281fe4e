#include "reports/cli/program.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "../fakes.h"

namespace plumb::check_engines_test {
namespace {

using ::testing::HasSubstr;

std::string error_of(const Engine& one) {
  const Engine first = fakes::engine("a");
  const std::vector<const Engine*> all{&first, &one};
  try {
    check_engines(all);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(CheckEngines, AcceptsTheWholeCatalog) {
  EXPECT_NO_THROW(check_engines(Catalog<Engine>::all()));
  EXPECT_EQ(error_of(fakes::engine("b")), "");
}

TEST(CheckEngines, NamesTheEngineAndWhatItLacks) {
  Engine mine = fakes::engine("mine");
  mine.build = nullptr;
  EXPECT_EQ(error_of(mine), "engine \"mine\" cannot build scenes: Engine::build is empty");
  mine = fakes::engine("mine");
  mine.unsupported = nullptr;
  EXPECT_THAT(error_of(mine), HasSubstr("Engine::unsupported is empty"));
  mine = fakes::engine("mine");
  mine.stepping = nullptr;
  EXPECT_THAT(error_of(mine), HasSubstr("Engine::stepping is empty"));
}

TEST(CheckEngines, WantsNamesThatTheCommandLineCanTellApart) {
  EXPECT_THAT(error_of(fakes::engine("a")), HasSubstr("\"a\" is there twice"));
  EXPECT_THAT(error_of(fakes::engine("")), HasSubstr("needs a name"));
  EXPECT_THAT(error_of(fakes::engine("my engine")), HasSubstr("without space"));
  EXPECT_THAT(error_of(fakes::engine("mine:2")), HasSubstr("without space"));
}

}  // namespace
}  // namespace plumb::check_engines_test
