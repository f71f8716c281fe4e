#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "reports/gate/writer.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

// For text and for attributes alike. XML 1.0 has no place for control characters, escaped or not.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char letter : printable(text, text.npos)) {
    switch (letter) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&apos;";
        break;
      default:
        out += letter;
    }
  }
  return out;
}

std::string test_case(const GateResult& result, const RunKey& run) {
  const std::string name = label_of(run.engine, run.method);
  const std::string about = run.scenario + (run.variant.empty() ? "" : " " + run.variant);
  std::string text =
      fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\"", escaped(about), escaped(name));
  std::string lines;
  const Regression* worst = nullptr;
  for (const Regression& one : result.regressions) {
    if (one.run != run) continue;
    if (worst == nullptr) worst = &one;
    lines += escaped(in_words(one)) + "\n";
  }
  if (worst == nullptr) return text + "/>\n";
  return text + fmt::format(">\n      <failure type=\"{}\" message=\"{}\">{}</failure>\n    </testcase>\n",
                            name_of(worst->change), escaped(worst->metric + ": " + worst->why), lines);
}

// As https://github.com/testmoapp/junitxml describes what readers of continuous integration take.
std::string junit(const GateResult& result) {
  std::set<RunKey> failed;
  for (const Regression& one : result.regressions) failed.insert(one.run);
  const std::string counts = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"0\" time=\"0\"",
                                         result.runs.size(), failed.size());
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  text += fmt::format("<testsuites name=\"plumb check\" {}>\n  <testsuite name=\"plumb check\" {}>\n", counts, counts);
  for (const RunKey& run : result.runs) text += test_case(result, run);
  text += fmt::format("    <system-out>{}\n", escaped(result.verdict));
  for (const std::string& note : result.notes) text += escaped(note) + "\n";
  return text + "</system-out>\n  </testsuite>\n</testsuites>\n";
}

const Catalog<GateWriter>::Entry junit_entry{
    {.name = "junit", .about = "JUnit XML, a test case for every case and engine", .text = junit}};

}  // namespace
}  // namespace plumb
