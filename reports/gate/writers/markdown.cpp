#include <fmt/format.h>

#include <string_view>

#include "reports/gate/writer.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

constexpr std::size_t most_rows = 100;  // a comment on a pull request holds 65536 letters

// What Markdown or HTML would take for its own goes as a character reference, which both show as that character.
std::string in_cell(const std::string& text) {
  constexpr std::string_view special = "&<>|`*_[]@#~\\!";
  std::string out;
  for (const char letter : printable(text, text.npos)) {
    if (special.find(letter) == special.npos) {
      out += letter;
    } else {
      out += fmt::format("&#{};", static_cast<int>(letter));
    }
  }
  return out;
}

std::string markdown(const GateResult& result) {
  std::string text = fmt::format("### Plumb: {}\n", in_cell(result.verdict));
  if (!result.passed()) {
    text += "\n| | run | what | before | now | allowed | why |\n|---|---|---|---|---|---|---|\n";
    for (std::size_t i = 0; i < result.regressions.size() && i < most_rows; ++i) {
      const Regression& one = result.regressions[i];
      text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", name_of(one.change), in_cell(one.run.text()),
                          in_cell(one.metric), in_cell(one.before), in_cell(one.now), in_cell(one.tolerance),
                          in_cell(one.why));
    }
    if (result.regressions.size() > most_rows) {
      text += fmt::format("\nAnd {} more.\n", result.regressions.size() - most_rows);
    }
    text += "\nIf this is as it should be, `plumb accept` makes it the baseline.\n";
  }
  for (const std::string& note : result.notes) text += "\n" + in_cell(note) + "\n";
  return text;
}

const Catalog<GateWriter>::Entry markdown_entry{
    {.name = "markdown", .about = "a summary for a pull request", .text = markdown}};

}  // namespace
}  // namespace plumb
