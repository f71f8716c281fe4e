#include "reports/gate/writers.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stack>
#include <string_view>

#include "../cli/commands/scene_files.h"
#include "../writers/sample.h"
#include "reports/gate/baseline.h"
#include "scenarios/catalog.h"

namespace plumb::writers_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A result that tries what writers must escape.
GateResult sample_gate_result() {
  const RunKey fine{"bounce", "e=0.5", "impulse", ""};
  const RunKey odd{"<img src=x onerror=alert(1)>", "a|b & \"c\" 'd' `e`\x01\n", "box2d", "x=1"};
  return {.verdict = "NOT as accepted: 1 of 2 runs differ (1 worse, 1 changed)",
          .runs = {fine, odd},
          .regressions = {{.run = odd,
                           .metric = "verdict",
                           .before = "right",
                           .now = "wrong",
                           .why = "]]> <b>diverged</b>",
                           .rule = Rule::verdict,
                           .change = Change::worse},
                          {.run = odd,
                           .metric = "energy_drift",
                           .before = "0.1 J",
                           .now = "0.2 J",
                           .tolerance = "+/- 1e-09",
                           .why = "1e+08 times the change that rounding explains",
                           .rule = Rule::bound}},
          .notes = {"Different platform (libm: this, was <that>)."}};
}

GateResult passed_gate_result() {
  return {.verdict = "as accepted: 1 run, to the bit", .runs = {{"bounce", "e=0.5", "impulse", ""}}};
}

TEST(GateText, HasTheVerdictThenTheWorstRegressions) {
  EXPECT_EQ(text_of(sample_gate_result(), 1),
            "NOT as accepted: 1 of 2 runs differ (1 worse, 1 changed)\n"
            "  worse: <img src=x onerror=alert(1)> a|b & \"c\" 'd' `e`??, box2d:x=1: verdict: right, now wrong; ]]> "
            "<b>diverged</b>\n"
            "  and 1 more\n"
            "Different platform (libm: this, was <that>).\n");
}

TEST(GateText, IsOneLineIfAllIsAsAccepted) {
  EXPECT_EQ(text_of(passed_gate_result(), 10), "as accepted: 1 run, to the bit\n");
}

TEST(GateText, StatesTheTolerance) {
  EXPECT_THAT(in_words(sample_gate_result().regressions[1]),
              ::testing::HasSubstr("energy_drift: 0.1 J, now 0.2 J, allowed +/- 1e-09; 1e+08 times"));
}

std::string markdown(const GateResult& result) { return Catalog<GateWriter>::find("markdown")->text(result); }

TEST(Markdown, HasARowForEachRegression) {
  const std::string text = markdown(sample_gate_result());
  EXPECT_THAT(text, HasSubstr("### Plumb: NOT as accepted"));
  EXPECT_THAT(text, HasSubstr("| 0.1 J | 0.2 J | +/- 1e-09 |"));
  EXPECT_THAT(text, HasSubstr("`plumb accept`"));
}

TEST(Markdown, EscapesNamesAndKeepsThemInOneCell) {
  const std::string text = markdown(sample_gate_result());
  EXPECT_THAT(text, Not(HasSubstr("<")));
  EXPECT_THAT(text, HasSubstr("&#60;img src=x"));
  const auto row = text.find("| worse |");
  const std::string line = text.substr(row, text.find('\n', row) - row);
  EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 8);
}

TEST(Markdown, StaysWithinACommentOnAPullRequest) {
  GateResult many = sample_gate_result();
  many.regressions.assign(10'000, many.regressions[0]);
  const std::string text = markdown(many);
  EXPECT_LT(text.size(), 65'536u);
  EXPECT_THAT(text, HasSubstr("And 9900 more."));
}

TEST(Markdown, IsOneLineIfAllIsAsAccepted) {
  EXPECT_EQ(markdown(passed_gate_result()), "### Plumb: as accepted: 1 run, to the bit\n");
}

std::string junit(const GateResult& result) { return Catalog<GateWriter>::find("junit")->text(result); }

// The length of the character reference at the start; 0 if there is none.
std::size_t reference_at(std::string_view text) {
  constexpr std::array<std::string_view, 5> known{"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"};
  const auto found = std::find_if(known.begin(), known.end(), [&](auto one) { return text.starts_with(one); });
  return found == known.end() ? 0 : found->size();
}

std::size_t name_at(std::string_view text) {
  const auto of_name = [](char letter) { return letter == '-' || (letter >= 'a' && letter <= 'z'); };
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), of_name) - text.begin());
}

struct Tag {
  std::string_view name;
  std::size_t length = 0;  // 0 if it is not a tag
  bool empty = false;      // <a/>
};

// <name key="value" ...> or <name .../>
Tag tag_at(std::string_view text) {
  std::size_t at = 1;
  Tag tag{.name = text.substr(at, name_at(text.substr(at)))};
  at += tag.name.size();
  while (text.substr(at).starts_with(' ')) {
    at += 1 + name_at(text.substr(at + 1));
    if (!text.substr(at).starts_with("=\"")) return {};
    for (at += 2; at < text.size() && text[at] != '"'; ++at) {
      if (text[at] == '<' || (text[at] == '&' && reference_at(text.substr(at)) == 0)) return {};
    }
    ++at;
  }
  tag.empty = at < text.size() && text[at] == '/';
  if (tag.empty) ++at;
  if (tag.name.empty() || at >= text.size() || text[at] != '>') return {};
  tag.length = at + 1;
  return tag;
}

// Why a text is not well-formed XML of elements with attributes and character data; "" if it is.
std::string malformed(const std::string& text) {
  constexpr std::string_view head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  std::string_view rest = text;
  if (!rest.starts_with(head)) return "no declaration";
  rest.remove_prefix(head.size());
  std::stack<std::string_view> open;
  while (!rest.empty()) {
    const std::string here(rest.substr(0, 40));
    std::size_t length = 1;
    if (rest.starts_with("</")) {
      const auto end = rest.find('>');
      if (end == rest.npos || open.empty() || rest.substr(2, end - 2) != open.top())
        return "closes what is not open: " + here;
      open.pop();
      length = end + 1;
    } else if (rest[0] == '<') {
      const Tag tag = tag_at(rest);
      if (tag.length == 0) return "not a tag: " + here;
      if (!tag.empty) open.push(tag.name);
      length = tag.length;
    } else if (rest[0] == '&') {
      length = reference_at(rest);
      if (length == 0) return "bare &: " + here;
    } else if (rest[0] == '>' || (static_cast<unsigned char>(rest[0]) < 0x20 && rest[0] != '\n')) {
      return "a character that is not allowed here: " + here;
    }
    rest.remove_prefix(length);
  }
  return open.empty() ? "" : "not closed: " + std::string(open.top());
}

TEST(Junit, IsWellFormedForAnyNames) {
  EXPECT_EQ(malformed(junit(sample_gate_result())), "");
  EXPECT_EQ(malformed(junit(passed_gate_result())), "");
  EXPECT_NE(malformed("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a>&</a>"), "");
  EXPECT_NE(malformed("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a><b></a>"), "");
  EXPECT_NE(malformed("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a b=\"&\"/>"), "");
  EXPECT_NE(malformed("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a b=\"<\"/>"), "");
}

TEST(Junit, HasATestCaseForEachRunAndTheReasonsOfThoseThatFail) {
  const std::string text = junit(sample_gate_result());
  EXPECT_THAT(text, HasSubstr("<testsuite name=\"plumb check\" tests=\"2\" failures=\"1\""));
  EXPECT_THAT(text, HasSubstr("<testcase classname=\"bounce e=0.5\" name=\"impulse\" time=\"0\"/>"));
  EXPECT_THAT(text,
              HasSubstr("name=\"box2d:x=1\" time=\"0\">\n      <failure type=\"worse\" message=\"verdict: ]]&gt;"));
  EXPECT_THAT(text, HasSubstr("energy_drift: 0.1 J, now 0.2 J"));
}

using ChangesSince = SceneFiles;

TEST_F(ChangesSince, AreEmptyIfAllIsAsAccepted) {
  const std::string file = put("canonical.json", to_text(baseline_of(sample_report())));
  const auto changes = changes_since(file, sample_report());
  ASSERT_TRUE(changes);
  EXPECT_EQ((*changes)["configuration"]["baseline"], "canonical.json");
  const auto& found = (*changes)["findings"];
  EXPECT_EQ(found["runs"], 3);
  EXPECT_TRUE(found["regressions"].empty()) << found.dump(1);
}

TEST_F(ChangesSince, NameTheRunWithBeforeAndNow) {
  const std::string file = put("canonical.json", to_text(baseline_of(sample_report())));
  Report report = sample_report();
  report.runs[0].verdict = Verdict::wrong;
  const auto regressions = changes_since(file, report).value()["findings"]["regressions"];
  ASSERT_FALSE(regressions.empty());
  EXPECT_EQ(regressions[0]["scenario"], "slide");
  EXPECT_EQ(regressions[0]["before"], "right");
  EXPECT_EQ(regressions[0]["now"], "wrong");
  EXPECT_EQ(regressions[0]["change"], "worse");
}

TEST_F(ChangesSince, LeaveOutRunsThatOnlyOneOfTheTwoHas) {
  Report before = sample_report();
  before.runs[0].scenario = "gone";
  const std::string file = put("canonical.json", to_text(baseline_of(before)));
  const auto found = changes_since(file, sample_report()).value()["findings"];
  EXPECT_EQ(found["runs"], 2);
  EXPECT_TRUE(found["regressions"].empty()) << found.dump(1);
}

TEST_F(ChangesSince, AreNulloptWithoutABaselineOrWithAnotherTimeStep) {
  EXPECT_FALSE(changes_since(at("none.json"), sample_report()));
  Report before = sample_report();
  for (RunRecord& run : before.runs) run.dt = 1.0 / 120;
  EXPECT_FALSE(changes_since(put("other.json", to_text(baseline_of(before))), sample_report()));
}

TEST_F(ChangesSince, ThrowForADamagedBaseline) {
  EXPECT_THROW(changes_since(put("damaged.json", "{"), sample_report()), std::invalid_argument);
}

}  // namespace
}  // namespace plumb::writers_test
