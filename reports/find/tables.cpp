#include "reports/find/tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/system/files.h"

namespace plumb {

std::string junit(const std::string& name, std::span<const TestCase> cases) {
  const auto failures = std::ranges::count_if(cases, [](const TestCase& one) { return !one.failure.empty(); });
  const std::string counts =
      fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"0\" time=\"0\"", cases.size(), failures);
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  text += fmt::format("<testsuites name=\"{}\" {}>\n  <testsuite name=\"{}\" {}>\n", name, counts, name, counts);
  for (const TestCase& one : cases) {
    text += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\"", xml_escaped(one.scene),
                        xml_escaped(one.engine));
    text += one.failure.empty()
                ? "/>\n"
                : fmt::format(">\n      <failure message=\"{}\"/>\n    </testcase>\n", xml_escaped(one.failure));
  }
  return text + "  </testsuite>\n</testsuites>\n";
}

std::string plain_table(std::span<const std::vector<std::string>> rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) line += fmt::format("{:<{}}  ", row[k], widths[k]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

}  // namespace plumb
