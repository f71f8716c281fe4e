#include <fmt/format.h>

#include "reports/gate/writer.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {

std::string in_words(const Regression& one) {
  std::string text = fmt::format("{}: {}: {}", name_of(one.change), one.run.text(), one.metric);
  if (!one.before.empty()) text += ": " + one.before;
  if (!one.now.empty()) text += (one.before.empty() ? ": now " : ", now ") + one.now;
  if (!one.tolerance.empty()) text += ", allowed " + one.tolerance;
  return printable(text + "; " + one.why, text.npos);
}

std::string text_of(const GateResult& result, std::size_t most) {
  std::string text = result.verdict + "\n";
  for (std::size_t i = 0; i < result.regressions.size() && i < most; ++i)
    text += "  " + in_words(result.regressions[i]) + "\n";
  if (result.regressions.size() > most) text += fmt::format("  and {} more\n", result.regressions.size() - most);
  for (const std::string& note : result.notes) text += printable(note, note.npos) + "\n";
  return text;
}

namespace {

const Catalog<GateWriter>::Entry text_entry{
    {.name = "text", .about = "everything that is not as accepted, a line each", .text = [](const GateResult& result) {
       return text_of(result, result.regressions.size());
     }}};

}  // namespace
}  // namespace plumb
