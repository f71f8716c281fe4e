#include "reports/run/selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "reference/programs/program_engine.h"
#include "reference/simulation.h"
#include "reports/engines/installed.h"
#include "reports/run/scene_file.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/nearest.h"

namespace plumb {
namespace {

constexpr std::string_view our_engine = "impulse";
constexpr std::string_view in_process =
    "in-process";  // before an engine's name: in Plumb's process, whatever it may do
constexpr std::string_view in_a_process = "isolated";  // likewise: in a process of its own

// "key=value", or one word that is a choice, but not the default, of exactly one option.
std::pair<std::string, std::string> parse_setting(const Engine& engine, const std::string& text) {
  std::vector<std::string> keys;
  for (const Option& option : engine.options) {
    const bool offered = std::any_of(option.choices.begin(), option.choices.end(),
                                     [&](const auto& choice) { return choice.first == text; });
    if (offered && option.value != text) keys.push_back(option.key);
  }
  if (keys.empty()) return parse_assignment(engine.name, text);
  if (keys.size() == 1) return {keys.front(), text};
  throw std::invalid_argument(
      fmt::format("{}: \"{}\" may mean {}={}", engine.name, text, fmt::join(keys, fmt::format("={} or ", text)), text));
}

// "": all.
std::vector<Case> parse_reported(const std::string& name) {
  std::vector<Case> cases = reported_cases();
  if (name.empty()) return cases;
  std::vector<std::string> names;
  for (Case& one : cases) {
    if (one.scenario->name == name) return {std::move(one)};
    names.push_back(one.scenario->name);
  }
  throw std::invalid_argument(unknown("reported case", name, names));
}

// Engines that Plumb does not come with run in processes of their own.
const Engine& placed(const Engine& engine) { return engine.in_process ? engine : isolated(engine); }

EngineConfig configured(const Engine& engine, std::string_view words) {
  Settings settings;
  for (const std::string& piece : split_at_commas(words)) {
    const auto [key, value] = parse_setting(engine, piece);
    settings[key] = value;
  }
  return {&engine, complete(engine, settings)};
}

const Engine& find_engine(const std::string& name) {
  for (const LeftOutEngine& one : left_out_engines()) {
    if (name == one.name) throw std::invalid_argument(fmt::format("engine \"{}\" is not built: {}", name, one.why));
  }
  return find_entry<Engine>("engine", name, [](const Engine& offered) { return !offered.exact; });
}

// The command of an engine that `plumb engine add` installs; nullopt for other names.
std::optional<std::string> command_of_packaged(const std::string& name) {
  const auto packaged = packaged_engines();
  if (std::ranges::none_of(packaged, [&](const PackagedEngine& one) { return one.name == name; })) return std::nullopt;
  const auto command = command_of_installed(name, engines_folder());
  if (command) return command;
  throw std::invalid_argument(fmt::format("\"{0}\" is not installed, or out of date: plumb engine add {0}", name));
}

// "COMMAND", or "COMMAND:key=value,...". Commands may contain colons; what follows the last one are settings if it has
// no space or slash, but an =.
EngineConfig parse_program(std::string_view word) {
  const std::size_t colon = word.rfind(':');
  const std::string_view last = colon == std::string_view::npos ? std::string_view{} : word.substr(colon + 1);
  const bool has_settings =
      last.find('=') != std::string_view::npos && last.find_first_of(" /") == std::string_view::npos;
  const Engine& engine = engine_of_program(std::string(has_settings ? word.substr(0, colon) : word));
  return configured(engine, has_settings ? last : std::string_view{});
}

}  // namespace

std::vector<Case> parse_cases(std::string_view word) {
  if (is_scene_file(word)) return {case_of_file(std::string(word))};
  const auto [name, rest] = split(word, ':');
  return name == tracker ? parse_reported(rest) : catalog_cases(word);
}

Case parse_case(std::string_view word) {
  const auto [name, rest] = split(word, ':');
  return rest.empty() ? catalog_case(word) : parse_cases(word).front();
}

EngineConfig parse_engine(std::string_view word) {
  if (word.starts_with(program_prefix)) return parse_program(word.substr(program_prefix.size()));
  const auto [name, rest] = split(word, ':');
  const Engine* closed_form = Catalog<Engine>::find(name);
  if (closed_form != nullptr && closed_form->exact) {
    throw std::invalid_argument("\"" + name +
                                "\" is a closed form, not an engine; `plumb run` compares every engine with it");
  }
  if (const auto command = command_of_packaged(name)) return configured(engine_of_program(*command, name), rest);
  if (name == in_process) {
    const auto [own, settings] = split(rest, ':');
    return Catalog<Engine>::find(own) == nullptr ? parse_engine(rest) : configured(find_engine(own), settings);
  }
  if (name == in_a_process) return configured(isolated(find_engine(split(rest, ':').first)), split(rest, ':').second);
  return configured(placed(find_engine(name)), rest);
}

std::vector<EngineConfig> default_engines() {
  std::vector<EngineConfig> configs;
  for (const Engine* engine : Catalog<Engine>::all()) {
    if (engine->exact) continue;
    configs.push_back({&placed(*engine), complete(*engine, {})});
    for (const Settings& other : engine->also) configs.push_back({&placed(*engine), complete(*engine, other)});
  }
  std::stable_partition(configs.begin(), configs.end(),
                        [](const EngineConfig& config) { return config.engine->name == our_engine; });
  return configs;
}

std::vector<Case> select_cases(const std::vector<std::string>& words, bool all, const std::vector<std::string>& extra) {
  std::vector<Case> cases;
  if (words.empty()) cases = default_cases(all);
  std::vector<std::string> named = words;
  if (words.empty() && !all) named = extra;
  for (const std::string& word : named) {
    for (Case& one : parse_cases(word)) cases.push_back(std::move(one));
  }
  return cases;
}

Plan select_plan(const std::vector<std::string>& words, bool all, const std::vector<std::string>& engines) {
  Plan plan{.cases = select_cases(words, all, {})};
  for (const std::string& word : engines) plan.configs.push_back(parse_engine(word));
  if (engines.empty()) plan.configs = default_engines();
  std::vector<std::string> names;
  for (const Case& one : plan.cases) names.push_back(one.scenario->name + ":" + one.variant);
  for (const EngineConfig& config : plan.configs) names.push_back(label_of(config.engine->name, config.method()));
  require_distinct(names);
  return plan;
}

void require_distinct(std::span<const std::string> names) {
  std::set<std::string> distinct;
  for (const std::string& name : names) {
    if (!distinct.insert(name).second) throw std::invalid_argument("\"" + name + "\" is selected twice");
  }
}

}  // namespace plumb
