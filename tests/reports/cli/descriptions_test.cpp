#include "reports/cli/descriptions.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "scenarios/scenario.h"

namespace plumb::descriptions_test {
namespace {

TEST(FamilyTable, HasARowForEveryFamily) {
  const std::string table = family_table();
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'),
            static_cast<std::ptrdiff_t>(2 + Catalog<Scenario>::all().size()));
  for (const Scenario* family : Catalog<Scenario>::all())
    EXPECT_THAT(table, testing::HasSubstr("| `" + family->name + "` | "));
}

TEST(FamilyTable, NamesQuestionAndAnswer) {
  EXPECT_THAT(
      family_table(),
      testing::HasSubstr("| friction | `slope` | 3 | Does a box on a slope stick below arctan(mu) and slide with "
                         "Coulomb friction above? | "));
}

// The table is made from the catalogue: plumb list scenarios --markdown.
TEST(FamilyTable, IsThatOfTheReadme) {
  std::ifstream readme(PLUMB_SOURCE_DIR "/scenarios/README.md");
  const std::string text{std::istreambuf_iterator<char>(readme), {}};
  EXPECT_TRUE(text.find(family_table()) != std::string::npos)
      << "scenarios/README.md: replace the table by what plumb list scenarios --markdown prints";
}

}  // namespace
}  // namespace plumb::descriptions_test
