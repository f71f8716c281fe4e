#include <fmt/core.h>

#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <vector>

#include "reference/simulation.h"
#include "reports/cli/command.h"
#include "reports/find/kind.h"
#include "reports/judge/invariant.h"
#include "reports/judge/metric.h"
#include "reports/judge/relation.h"
#include "reports/run/scene_file.h"
#include "scenarios/catalog.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/nearest.h"

namespace plumb::commands::list {
namespace {

void list_scenarios() {
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    fmt::print("  {:<16} {}\n", scenario->name, scenario->question);
    for (const Parameter& parameter : scenario->parameters) {
      fmt::print("    {} = {} {} ({} ... {}): {}\n", parameter.name, parameter.value, parameter.unit, parameter.min,
                 parameter.max, parameter.about);
    }
    for (const Variant& variant : scenario->variants) fmt::print("    variant \"{}\"\n", variant.label);
  }
}

void list_engines() {
  for (const Engine* engine : Catalog<Engine>::all()) {
    fmt::print("  {:<16} {}{}; {}\n", engine->name, engine->exact ? "closed form: " : "", engine->about,
               engine->source);
    for (const Option& option : engine->options) {
      fmt::print("    {} = {}: {}\n", option.key, option.value, option.about);
      for (const auto& [choice, about] : option.choices) fmt::print("      {:<14} {}\n", choice, about);
      if (option.choices.empty()) fmt::print("      {} ... {}\n", option.min, option.max);
    }
  }
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

int list(const std::string& what) {
  const std::vector<std::pair<std::string, std::function<void()>>> lists{
      {"scenarios", list_scenarios},        {"engines", list_engines},     {"metrics", list_metrics},
      {"invariants", list_invariants},      {"relations", list_relations}, {"kinds", list_kinds},
      {std::string(tracker), list_reported}};
  std::vector<std::string> names;
  bool found = false;
  for (const auto& [name, print] : lists) {
    names.push_back(name);
    if (!what.empty() && what != name) continue;
    found = true;
    fmt::print("{}\n", name);
    print();
  }
  if (!found) throw std::invalid_argument(unknown("list", what, names));
  return 0;
}

const Catalog<Command>::Entry entry{
    {.name = "list",
     .about = "Show scenarios, engines, metrics, invariants, relations, kinds of random scenes and reported cases",
     .examples = "  plumb list\n"
                 "  plumb list engines    with their options and where they come from\n",
     .attach = [](CLI::App& app) {
       const auto what = std::make_shared<std::string>();
       app.add_option("what", *what,
                      "scenarios, engines, metrics, invariants, relations, kinds or tracker; default: all")
           ->type_name("WHAT");
       return [what] { return list(*what); };
     }}};

}  // namespace
}  // namespace plumb::commands::list
