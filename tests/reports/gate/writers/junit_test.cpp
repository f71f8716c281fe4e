#include <gmock/gmock.h>

#include <regex>
#include <stack>

#include "reports/gate/writer.h"
#include "scenarios/catalog.h"
#include "tests/reports/gate/writers/sample.h"

namespace plumb {
namespace {

using ::testing::HasSubstr;

std::string junit(const GateResult& result) { return Catalog<GateWriter>::find("junit")->text(result); }

// Why a text is no well-formed XML of elements with attributes and character data; "" where it is.
std::string malformed(const std::string& text) {
  static const std::regex start(R"(^<([a-z-]+)(?: [a-z]+="[^"<]*")*(/?)>)");
  static const std::regex reference("^&(amp|lt|gt|quot|apos);");
  std::stack<std::string> open;
  std::smatch match;
  std::string rest = text;
  const std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  if (rest.rfind(head, 0) != 0) return "no declaration";
  rest.erase(0, head.size());
  while (!rest.empty()) {
    std::size_t length = 1;
    if (rest.rfind("</", 0) == 0) {
      const auto end = rest.find('>');
      if (open.empty() || rest.substr(2, end - 2) != open.top())
        return "closes what is not open: " + rest.substr(0, 40);
      open.pop();
      length = end + 1;
    } else if (rest[0] == '<') {
      if (!std::regex_search(rest, match, start)) return "no tag: " + rest.substr(0, 40);
      const std::string tag = match.str(0);
      for (auto at = tag.find('&'); at != std::string::npos; at = tag.find('&', at + 1)) {
        if (!std::regex_search(tag.substr(at), reference)) return "bare & in " + tag;
      }
      if (match.str(2).empty()) open.push(match.str(1));
      length = tag.size();
    } else if (rest[0] == '&') {
      if (!std::regex_search(rest, match, reference)) return "bare &: " + rest.substr(0, 40);
      length = static_cast<std::size_t>(match.length(0));
    } else if (rest[0] == '>' || (static_cast<unsigned char>(rest[0]) < 0x20 && rest[0] != '\n')) {
      return "a character that may not stand there: " + rest.substr(0, 40);
    }
    rest.erase(0, length);
  }
  return open.empty() ? "" : "not closed: " + open.top();
}

TEST(Junit, IsWellFormedWhateverNamesSay) {
  EXPECT_EQ(malformed(junit(sample_gate_result())), "");
  EXPECT_EQ(malformed(junit(passed_gate_result())), "");
  EXPECT_NE(malformed("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a>&</a>"), "");
  EXPECT_NE(malformed("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a><b></a>"), "");
}

TEST(Junit, HasATestCaseForEveryRunAndTheReasonsOfThoseThatFail) {
  const std::string text = junit(sample_gate_result());
  EXPECT_THAT(text, HasSubstr("<testsuite name=\"plumb check\" tests=\"2\" failures=\"1\""));
  EXPECT_THAT(text, HasSubstr("<testcase classname=\"bounce e=0.5\" name=\"impulse\" time=\"0\"/>"));
  EXPECT_THAT(text,
              HasSubstr("name=\"box2d:x=1\" time=\"0\">\n      <failure type=\"worse\" message=\"verdict: ]]&gt;"));
  EXPECT_THAT(text, HasSubstr("energy_drift: 0.1 J, now 0.2 J"));
}

}  // namespace
}  // namespace plumb
