#include <gmock/gmock.h>

#include "../../history/sample.h"
#include "../../saying.h"
#include "../../writers/sample.h"
#include "reports/writers/json.h"

namespace plumb::history_test {
namespace {

using ::testing::HasSubstr;

class HistoryCommand : public InFolder {
 protected:
  Said history(std::vector<std::string> words, const std::string& file = "h") const {
    words.insert(words.begin(), "history");
    words.insert(words.end(), {"--file", path(file)});
    return say(words);
  }

  void put_lines(int from, int to) const {
    std::string lines;
    for (int i = from; i < to; ++i) lines += to_line(sample_snapshot(i)) + "\n";
    put("lines", lines);
  }
};

TEST_F(HistoryCommand, AddsAReportOnce) {
  put("report.json", to_json(sample_report()).dump());
  const std::vector<std::string> words{"add", path("report.json"), "--commit", "c0ffee-gone", "--at", "2026-11-21"};
  const Said first = history(words);
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("of c0ffee-gone at 2026-11-21T00:00:00Z"));
  EXPECT_THAT(history(words).out, HasSubstr("already there"));
  const Said list = history({"list"});
  EXPECT_THAT(list.out, HasSubstr("c0ffee-gone"));
  EXPECT_THAT(list.out, HasSubstr("1 wrong"));
  EXPECT_EQ(std::count(list.out.begin(), list.out.end(), '\n'), 1);
}

TEST_F(HistoryCommand, WantsToKnowWhenAndAddsNothingElse) {
  put("report.json", to_json(sample_report()).dump());
  EXPECT_EQ(history({"add", path("report.json"), "--commit", "c0ffee-gone"}).code, 2);
  EXPECT_EQ(history({"add", path("report.json"), "--commit", "c0ffee-gone", "--at", "soon"}).code, 2);
  put("other.json", "{}");
  const Said other = history({"add", path("report.json"), path("other.json"), "--commit", "c", "--at", "2026-11-21"});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("other.json: "));
  EXPECT_FALSE(std::filesystem::exists(path("h")));
}

TEST_F(HistoryCommand, TakesBackExactlyWhatItExports) {
  put_lines(0, 20);
  EXPECT_THAT(history({"import", path("lines")}).out, HasSubstr("20 of 20 snapshots added, 0 already there"));
  EXPECT_THAT(history({"import", path("lines")}).out, HasSubstr("0 of 20 snapshots added, 20 already there"));
  EXPECT_EQ(history({"export", path("out")}).code, 0);
  EXPECT_THAT(history({"import", path("out")}).out, HasSubstr("0 of 20 snapshots added, 20 already there"));
}

TEST_F(HistoryCommand, ImportsNothingOfAFileInWhichADigitWasChanged) {
  put_lines(0, 2);
  history({"import", path("lines")});
  history({"export", path("out")});
  std::string changed = bytes("out");
  changed.replace(changed.rfind("e=0.5"), 5, "e=0.6");
  put("out", changed);
  const Said said = history({"import", path("out")});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("line 2: was changed since it was exported"));
}

TEST_F(HistoryCommand, ImportsNothingOfAFileWithABrokenLine) {
  put_lines(0, 2);
  put("lines", bytes("lines") + "{\"plumb_history\":1}\n");
  const Said said = history({"import", path("lines")});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("line 3: "));
  EXPECT_FALSE(std::filesystem::exists(path("h")));
}

TEST_F(HistoryCommand, TellsWhatChangedAndSinceWhen) {
  put_lines(0, 20);
  history({"import", path("lines")});
  const Said changes = history({"changes"});
  EXPECT_EQ(changes.code, 0);
  EXPECT_THAT(changes.out, HasSubstr("2026-01-11 c0ffee10\n"
                                     "  bounce e=0.5, impulse, dt 0.01667: right -> wrong\n"
                                     "  bounce e=0.5, impulse, dt 0.01667: energy_rise 1 -> 2 J (+100 %, exact)\n"));
  const Said trend = history({"trend", "energy_rise", "--engine", "impulse"});
  EXPECT_THAT(trend.out, HasSubstr("20 values, 1 ... 2 J"));
  EXPECT_THAT(trend.out, HasSubstr("2026-01-11 c0ffee10  1 -> 2 J"));
}

TEST_F(HistoryCommand, NamesTheNearestMetric) {
  put_lines(0, 3);
  history({"import", path("lines")});
  const Said said = history({"trend", "energy_raise"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("did you mean \"energy_rise\"?"));
  EXPECT_EQ(history({"trend", "energy_rise", "--scenario", "slope"}).code, 2);
}

TEST_F(HistoryCommand, RefusesAForeignFileAndLeavesIt) {
  put("h",
      "my diary, which is longer than a hundred bytes, and which nobody should ever write to, whatever they ask for");
  put_lines(0, 1);
  const std::string before = bytes("h");
  for (const char* word : {"list", "changes"}) EXPECT_EQ(history({word}).code, 2);
  const Said said = history({"import", path("lines")});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("is not a Plumb history"));
  EXPECT_EQ(bytes("h"), before);
  EXPECT_EQ(say({"report", "--history", path("h"), "--out", path("out")}).code, 2);
  EXPECT_FALSE(std::filesystem::exists(path("out")));
}

TEST_F(HistoryCommand, WritesAPage) {
  put_lines(0, 20);
  history({"import", path("lines")});
  const Said said = history({"page", "--out", path("")});
  if (said.err.find("built without Node.js") != std::string::npos) GTEST_SKIP() << "no page";
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(bytes("history.html"), HasSubstr("\"study\":\"history\""));
}

}  // namespace
}  // namespace plumb::history_test
