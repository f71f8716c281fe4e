#include "reports/writers/junit.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "reports/system/files.h"
#include "reports/writers/output.h"
#include "reports/writers/summary.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

// What `plumb run` fails by; "" if it doesn't.
std::string failure_of(const RunRecord& run) {
  if (run.verdict == Verdict::failed) return run.reason;
  if (run.verdict != Verdict::wrong) return "";
  std::string all;
  const auto add = [&](const auto& check) { all += (all.empty() ? "" : "; ") + in_words(check); };
  for (const TruthCheck& check : run.truth) {
    if (!check.passed) add(check);
  }
  for (const InvariantCheck& check : run.invariants) {
    if (check.status == CheckStatus::broken) add(check);
  }
  if (!run.reason.empty()) all += (all.empty() ? "" : "; ") + run.reason;
  return all.empty() ? name_of(run.verdict) : all;
}

std::string of_report(const Report& report) {
  std::vector<TestCase> cases;
  for (const RunRecord& run : report.runs) {
    if (run.exact) continue;
    cases.push_back({.scene = run.scenario + ":" + run.variant,
                     .engine = label_of(run.engine, run.method),
                     .failure = failure_of(run),
                     .skipped = run.verdict == Verdict::not_supported ? run.reason : ""});
  }
  return junit("plumb", cases);
}

const Catalog<Writer>::Entry junit_entry{
    {.name = "junit", .file = "report.xml", .text = [](const Report& report, std::string&) {
       return std::optional(of_report(report));
     }}};

}  // namespace

std::string junit(const std::string& name, std::span<const TestCase> cases) {
  const auto failures = std::ranges::count_if(cases, [](const TestCase& one) { return !one.failure.empty(); });
  const auto skipped = std::ranges::count_if(cases, [](const TestCase& one) { return !one.skipped.empty(); });
  const std::string counts = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\" time=\"0\"",
                                         cases.size(), failures, skipped);
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  text += fmt::format("<testsuites name=\"{}\" {}>\n  <testsuite name=\"{}\" {}>\n", name, counts, name, counts);
  for (const TestCase& one : cases) {
    text += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\"", xml_escaped(one.scene),
                        xml_escaped(one.engine));
    const char* tag = !one.failure.empty() ? "failure" : "skipped";
    const std::string& why = !one.failure.empty() ? one.failure : one.skipped;
    text +=
        why.empty() ? "/>\n" : fmt::format(">\n      <{} message=\"{}\"/>\n    </testcase>\n", tag, xml_escaped(why));
  }
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace plumb
