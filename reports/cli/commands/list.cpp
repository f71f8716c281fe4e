#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <vector>

#include "reference/simulation.h"
#include "reports/cli/command_line.h"
#include "reports/cli/descriptions.h"
#include "reports/find/kind.h"
#include "reports/judge/invariant.h"
#include "reports/judge/metric.h"
#include "reports/judge/relation.h"
#include "reports/run/scene_file.h"
#include "reports/system/layout.h"
#include "reports/system/terminal.h"
#include "scenarios/catalog.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/nearest.h"

namespace plumb::commands::list {
namespace {

// One line an entry: cut to the terminal's width, whole if standard output is none.
void print_line(const std::string& name, std::size_t columns, const std::string& about) {
  fmt::print("{}\n", cut(fmt::format("  {:<{}} {}", name, columns, about), terminal_width(std::string::npos)));
}

// A line a scenario, by group, below what is at stake.
void list_scenarios() {
  std::map<std::string, std::vector<const Scenario*>> groups;
  std::size_t longest = 0;
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    groups[scenario->group].push_back(scenario);
    longest = std::max(longest, scenario->name.size());
  }
  for (const auto& [name, scenarios] : groups) {
    const ScenarioGroup* group = Catalog<ScenarioGroup>::find(name);
    if (group == nullptr) throw std::logic_error("scenarios/group.cpp lacks " + name);
    fmt::print("{}\n", cut(group->title + ": " + group->stake, terminal_width(std::string::npos)));
    for (const Scenario* scenario : scenarios) print_line(scenario->name, longest, scenario->question);
  }
}

void list_engines() {
  const std::size_t width = terminal_width(100);
  for (const Engine* engine : Catalog<Engine>::all())
    fmt::print("{}{}\n{}", engine->name, engine->exact ? " (closed form)" : "", description_of(*engine, width));
}

// What most users look for.
void list_briefly() {
  list_scenarios();
  fmt::print("engines\n");
  for (const Engine* engine : Catalog<Engine>::all()) {
    if (!engine->exact) print_line(engine->name, 16, engine->about);
  }
  for (const LeftOutEngine& one : left_out_engines())
    print_line(std::string(one.name), 16, "not built: " + std::string(one.why));
  fmt::print("\nplumb show NAME has a scenario's parameters or an engine's options. plumb list WHAT: ");
}

void list_metrics() {
  for (const Metric* metric : Catalog<Metric>::all()) {
    fmt::print("  {:<24} {:<9} {}\n", metric->name, metric->unit, metric->definition);
  }
}

void list_invariants() {
  for (const Invariant* invariant : Catalog<Invariant>::all()) {
    fmt::print("  {:<24} {:<9} {}\n", invariant->name, invariant->unit, invariant->definition);
  }
}

void list_relations() {
  for (const MetamorphicRelation* relation : Catalog<MetamorphicRelation>::all()) {
    fmt::print("  {:<24} {:<9} {}\n", relation->name, relation->unit, relation->definition);
  }
}

void list_kinds() {
  for (const Kind* kind : Catalog<Kind>::all()) {
    fmt::print("  {:<24} {:<9} {}\n", kind->name, kind->posed == Posed::well ? "" : name_of(kind->posed), kind->about);
  }
}

void list_reported() {
  for (const Case& one : reported_cases())
    fmt::print("  {}:{}\n    {}\n", tracker, one.scenario->name, one.scenario->question);
}

int list(const std::string& what, bool markdown) {
  if (markdown) {
    if (!what.empty() && what != "scenarios") throw std::invalid_argument("only scenarios have a Markdown table");
    fmt::print("{}", family_table());
    return 0;
  }
  const std::vector<std::pair<std::string, std::function<void()>>> lists{
      {"scenarios", list_scenarios},        {"engines", list_engines},     {"metrics", list_metrics},
      {"invariants", list_invariants},      {"relations", list_relations}, {"kinds", list_kinds},
      {std::string(tracker), list_reported}};
  std::vector<std::string> names;
  for (const auto& [name, print] : lists) names.push_back(name);
  if (what.empty()) {
    list_briefly();
    fmt::print("{}.\n", fmt::join(names, ", "));
    return 0;
  }
  const auto found = std::ranges::find(names, what);
  if (found == names.end()) throw std::invalid_argument(unknown("list", what, names));
  lists[static_cast<std::size_t>(found - names.begin())].second();
  return 0;
}

const Catalog<Command>::Entry entry{
    {.name = "list",
     .about = "List scenarios and engines, or metrics, invariants, relations, kinds of random scenes, reported cases",
     .examples = "  plumb list            scenarios and engines, a line each\n"
                 "  plumb list engines    with their options and where they come from\n",
     .attach = [](CLI::App& app) {
       const auto what = std::make_shared<std::string>();
       const auto markdown = std::make_shared<bool>(false);
       app.add_option(
              "what", *what,
              "scenarios, engines, metrics, invariants, relations, kinds or tracker; default: scenarios and engines")
           ->type_name("WHAT");
       app.add_flag("--markdown", *markdown, "Print the scenarios as a Markdown table");
       return [what, markdown] { return list(*what, *markdown); };
     }}};

}  // namespace
}  // namespace plumb::commands::list
