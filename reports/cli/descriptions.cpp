#include "reports/cli/descriptions.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "reference/faults/altered_engine.h"
#include "reference/simulation.h"
#include "reports/cli/glossary.h"
#include "reports/find/kind.h"
#include "reports/judge/invariant.h"
#include "reports/judge/metric.h"
#include "reports/judge/relation.h"
#include "reports/run/selection.h"
#include "reports/system/layout.h"
#include "scenarios/catalog.h"
#include "scenarios/scenario.h"

namespace plumb {
namespace {

std::string parameter_text(const Parameter& one, std::size_t columns, std::size_t width) {
  const std::string unit = one.unit.empty() ? "" : " " + one.unit;
  return beside("  " + one.name, columns,
                fmt::format("{}{}, from {} to {}{}: {}", one.value, unit, one.min, one.max, one.whole ? ", whole" : "",
                            one.about),
                width);
}

std::string changes_of(const Variant& variant) {
  std::string text;
  for (const auto& [name, value] : variant.changes)
    text += fmt::format("{}{}={:.6g}", text.empty() ? "" : ",", name, value);
  return text.empty() ? "the defaults" : text;
}

std::string answer_of(const Case& one) {
  if (one.closed_form == nullptr) {
    return "no closed form; a converged reference where two engines agree, and the invariants";
  }
  return fmt::format("closed form {}: {} ({})", one.closed_form->name, one.closed_form->about, one.closed_form->source);
}

// "speed of box: g (sin a - mu cos a) t", each once.
std::vector<std::string> checks_of(const Case& one) {
  std::vector<std::string> checks;
  for (const Expectation& check : one.scenario->expectations(one.parameters)) {
    const std::string text =
        fmt::format("{}{}: {}", name_of(check.quantity), check.body.empty() ? "" : " of " + check.body, check.source);
    if (std::ranges::find(checks, text) == checks.end()) checks.push_back(text);
  }
  return checks;
}

template <class T>
void add_definitions(const std::string& kind, std::vector<Topic>& all) {
  for (const T* one : Catalog<T>::all()) {
    all.push_back({kind, one->name, [one](std::size_t width) {
                     const std::string unit = one->unit.empty() ? "" : " (" + one->unit + ")";
                     return wrapped(one->definition + unit, 2, width);
                   }});
  }
}

Topic topic_of(const std::string& kind, const std::string& name, const std::string& text) {
  return {kind, name, [text](std::size_t width) { return wrapped(text, 2, width); }};
}

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

std::string description_of(const Case& one, std::size_t width) {
  constexpr std::size_t most_checks = 8;
  const Scenario& scenario = *one.scenario;
  std::string text = wrapped(scenario.question, 2, width);
  std::size_t columns = 12;
  for (const Parameter& parameter : scenario.parameters) columns = std::max(columns, parameter.name.size() + 4);
  if (!scenario.parameters.empty()) text += "parameters\n";
  for (const Parameter& parameter : scenario.parameters) text += parameter_text(parameter, columns, width);
  text += "variants\n";
  for (const Variant& variant : scenario.variants)
    text += beside("  " + variant.label, columns, changes_of(variant), width);
  text += "answer\n" + wrapped(answer_of(one), 2, width);
  const std::vector<std::string> checks = checks_of(one);
  if (!checks.empty()) text += "checks\n";
  for (std::size_t i = 0; i < std::min(checks.size(), most_checks); ++i) text += wrapped(checks[i], 2, width);
  if (checks.size() > most_checks) text += fmt::format("  and {} more\n", checks.size() - most_checks);
  return text;
}

std::string description_of(const Engine& engine, std::size_t width) {
  constexpr std::size_t columns = 22;
  std::string text = wrapped(engine.about + "; " + engine.source, 2, width);
  if (!engine.exact) {
    const std::string language = engine.language.empty() ? "language not stated" : engine.language;
    text += wrapped(fmt::format("{}, execution {}", language, name_of(engine.execution)), 2, width);
  }
  for (const Option& option : engine.options) {
    const std::string range = option.choices.empty() ? fmt::format(" ({:g} to {:g})", option.min, option.max) : "";
    text += beside(fmt::format("  {}={}", option.key, option.value), columns, option.about + range, width);
    for (const auto& [choice, about] : option.choices) text += beside("    " + choice, columns, about, width);
  }
  if (!engine.caveats.empty()) text += "what it does differently\n";
  for (const std::string& caveat : engine.caveats) text += beside("-", 3, caveat, width);
  return text;
}

std::string description_of(const PackagedEngine& engine, std::size_t width) {
  if (command_of_installed(engine.name, engines_folder()))
    return description_of(*parse_engine(engine.name).engine, width);
  return wrapped(fmt::format("{}; not installed: plumb engine add {}", engine.about, engine.name), 2, width);
}

std::vector<Topic> topics() {
  std::vector<Topic> all;
  for (const GlossaryWord& word : glossary()) all.push_back(topic_of("glossary", word.name, word.meaning));
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    all.push_back({"scenario", scenario->name,
                   [scenario](std::size_t width) { return description_of(parse_case(scenario->name), width); }});
  }
  for (const Engine* engine : Catalog<Engine>::all()) {
    all.push_back({engine->exact ? "closed form" : "engine", engine->name,
                   [engine](std::size_t width) { return description_of(*engine, width); }});
  }
  for (const PackagedEngine& engine : packaged_engines()) {
    all.push_back(
        {"engine of npm", engine.name, [engine](std::size_t width) { return description_of(engine, width); }});
  }
  add_definitions<Metric>("metric", all);
  add_definitions<Invariant>("invariant", all);
  add_definitions<MetamorphicRelation>("relation", all);
  for (const Kind* kind : Catalog<Kind>::all())
    all.push_back(topic_of("kind of random scenes", kind->name, kind->about));
  for (const Control* control : Catalog<Control>::all())
    all.push_back(topic_of("control", control->name, control->about));
  for (const Fault& fault : all_faults()) all.push_back(topic_of("fault", fault.name, fault.about));
  return all;
}

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
