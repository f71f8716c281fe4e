#include <gmock/gmock.h>

#include <sstream>

#include "reports/writers/output.h"
#include "sample.h"
#include "scenarios/catalog.h"

namespace plumb::csv_test {
namespace {

std::vector<std::string> lines() {
  std::string why_not;
  std::istringstream text(*Catalog<Writer>::find("csv")->text(sample_report(), why_not));
  std::vector<std::string> all;
  for (std::string line; std::getline(text, line);) all.push_back(line);
  return all;
}

// Commas outside quotes.
std::size_t commas(const std::string& line) {
  std::size_t count = 0;
  bool quoted = false;
  for (const char letter : line) {
    if (letter == '"') quoted = !quoted;
    if (letter == ',' && !quoted) ++count;
  }
  return count;
}

TEST(Csv, HasARowForEachMetricTruthAndInvariantOfEachRun) {
  EXPECT_EQ(lines().size(), 1u + 1 + 5 + 1)
      << "head; exact: a metric; wrong: a metric, a truth and three invariants; failed: itself";
}

TEST(Csv, HasTheSameColumnsInEveryRow) {
  for (const std::string& line : lines()) EXPECT_EQ(commas(line), commas(lines()[0])) << line;
}

TEST(Csv, QuotesAndLeavesNumbersThatAreNoneEmpty) {
  EXPECT_THAT(lines()[3], ::testing::HasSubstr("\"solver=one,integrator=another,iterations=1000\""));
  EXPECT_THAT(lines()[3], ::testing::HasSubstr("truth,x,\"box, \"\"the\"\" first\",2,,m,0.3333333333333333,,0.1,0,no"));
}

}  // namespace
}  // namespace plumb::csv_test
