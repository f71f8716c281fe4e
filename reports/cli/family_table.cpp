#include "reports/cli/family_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/catalog.h"
#include "scenarios/group.h"
#include "scenarios/scenario.h"

namespace plumb {
namespace {

// What the first check compares with: its source up to the reason for the tolerance, which a semicolon separates.
std::string law_of(const Scenario& family) {
  const std::vector<Expectation> checks = family.expectations(complete(family, family.variants.front().changes));
  if (checks.empty()) return "invariants, and a converged reference";
  return checks.front().source.substr(0, checks.front().source.find(';'));
}

std::string answer_of(const Scenario& family) {
  const Engine* closed_form = family.closed_form.empty() ? nullptr : Catalog<Engine>::find(family.closed_form);
  return law_of(family) + (closed_form == nullptr ? "" : "; " + closed_form->source);
}

// A bar would end a cell.
std::string cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, "\\");
  return text;
}

}  // namespace

std::string family_table() {
  std::vector<const Scenario*> families = Catalog<Scenario>::all();
  std::ranges::stable_sort(families, {}, [](const Scenario* one) { return one->group; });
  std::string table = "| group | family | cases | question | answer |\n|---|---|---|---|---|\n";
  for (const Scenario* one : families) {
    const ScenarioGroup* group = Catalog<ScenarioGroup>::find(one->group);
    table += fmt::format("| {} | `{}` | {} | {} | {} |\n", group == nullptr ? one->group : group->title, one->name,
                         one->variants.size(), cell(one->question), cell(answer_of(*one)));
  }
  return table;
}

}  // namespace plumb
