#include "reports/cli/glossary.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "reports/report.h"

namespace plumb::glossary_test {
namespace {

TEST(Glossary, ReadsTheTablesOfWordsAsPlainText) {
  const auto words = glossary_of(
      "# Title\n\n| word | meaning |\n|---|---|\n| *right*, coarse | \\|a - b\\| of `x`, see [here](there.md) |\n\n"
      "| folder | contents |\n|---|---|\n| a | b |\n");
  ASSERT_EQ(words.size(), 2u);
  EXPECT_EQ(words[0].name, "right");
  EXPECT_EQ(words[1].name, "coarse");
  EXPECT_EQ(words[1].meaning, "|a - b| of x, see here");
}

TEST(Glossary, HasEveryVerdict) {
  const auto words = glossary();
  for (const Verdict one : {Verdict::right, Verdict::coarse, Verdict::wrong, Verdict::plausible, Verdict::no_evidence,
                            Verdict::not_supported, Verdict::failed, Verdict::beyond_horizon}) {
    EXPECT_TRUE(std::ranges::any_of(words, [&](const GlossaryWord& word) { return word.name == name_of(one); }))
        << name_of(one);
  }
}

}  // namespace
}  // namespace plumb::glossary_test
