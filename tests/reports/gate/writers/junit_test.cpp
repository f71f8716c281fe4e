#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <stack>
#include <string>
#include <string_view>

#include "reports/gate/writer.h"
#include "sample.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

using ::testing::HasSubstr;

std::string junit(const GateResult& result) { return Catalog<GateWriter>::find("junit")->text(result); }

// How many characters at the start are a reference to another one; 0: none.
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
  std::size_t length = 0;  // 0: no tag
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

// Why a text is no well-formed XML of elements with attributes and character data; "" where it is.
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
      if (tag.length == 0) return "no tag: " + here;
      if (!tag.empty) open.push(tag.name);
      length = tag.length;
    } else if (rest[0] == '&') {
      length = reference_at(rest);
      if (length == 0) return "bare &: " + here;
    } else if (rest[0] == '>' || (static_cast<unsigned char>(rest[0]) < 0x20 && rest[0] != '\n')) {
      return "a character that may not stand there: " + here;
    }
    rest.remove_prefix(length);
  }
  return open.empty() ? "" : "not closed: " + std::string(open.top());
}

TEST(Junit, IsWellFormedWhateverNamesSay) {
  EXPECT_EQ(malformed(junit(sample_gate_result())), "");
  EXPECT_EQ(malformed(junit(passed_gate_result())), "");
  EXPECT_NE(malformed("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a>&</a>"), "");
  EXPECT_NE(malformed("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a><b></a>"), "");
  EXPECT_NE(malformed("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a b=\"&\"/>"), "");
  EXPECT_NE(malformed("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a b=\"<\"/>"), "");
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
