#include "reports/find/suspect.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "reference/faults/fault.h"
#include "reports/run/selection.h"
#include "scenarios/scene/nearest.h"

namespace plumb {
namespace {

constexpr std::string_view fault_mark = "fault:";
constexpr std::string_view closed_form_mark = "closed-form:";

Suspect suspect_of(const Fault& fault) {
  Suspect suspect{.name = std::string(fault_mark) + fault.name,
                  .faulty = std::make_shared<const Engine>(faulty_engine(fault)),
                  .sound = std::make_shared<const Engine>(right_engine(fault))};
  suspect.config = {suspect.faulty.get(), settings_of(fault)};
  suspect.right = EngineConfig{suspect.sound.get(), settings_of(fault)};
  return suspect;
}

std::vector<Suspect> faults_named(std::string_view name) {
  std::vector<Suspect> found;
  std::vector<std::string> names{"all"};
  for (const Fault& fault : all_faults()) {
    if (name == "all" || name == fault.name) found.push_back(suspect_of(fault));
    names.push_back(fault.name);
  }
  if (found.empty()) throw std::invalid_argument(unknown("fault", std::string(name), names));
  return found;
}

std::vector<Suspect> closed_forms_named(std::string_view name) {
  std::vector<Suspect> found;
  std::vector<std::string> names{"all"};
  for (const Engine* engine : Catalog<Engine>::all()) {
    if (!engine->exact) continue;
    names.push_back(engine->name);
    if (name != "all" && name != engine->name) continue;
    found.push_back({.name = std::string(closed_form_mark) + engine->name, .config = {engine, complete(*engine, {})}});
  }
  if (found.empty()) throw std::invalid_argument(unknown("closed form", std::string(name), names));
  return found;
}

}  // namespace

bool is_closed_form(std::string_view suspect) { return suspect.starts_with(closed_form_mark); }

std::vector<Suspect> parse_suspects(std::string_view word) {
  if (is_closed_form(word)) return closed_forms_named(word.substr(closed_form_mark.size()));
  if (word.starts_with(fault_mark)) return faults_named(word.substr(fault_mark.size()));
  return {{.name = std::string(word), .config = parse_engine(word)}};
}

std::vector<Suspect> parse_suspects(const std::vector<std::string>& words) {
  std::vector<Suspect> all;
  for (const std::string& word : words) std::ranges::move(parse_suspects(word), std::back_inserter(all));
  if (!words.empty()) return all;
  for (const EngineConfig& config : default_engines()) {
    if (config.method().empty()) all.push_back({.name = config.engine->name, .config = config});
  }
  return all;
}

}  // namespace plumb
