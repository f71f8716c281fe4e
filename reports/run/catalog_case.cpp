#include "reports/run/catalog_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

namespace plumb {
namespace {

double parse_decimal(std::string_view what, std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc{} && end == text.data() + text.size() && std::isfinite(number)) return number;
  throw std::invalid_argument(std::string(what) + ": \"" + std::string(text) +
                              "\" is not a number; write 0.01 or 1/60");
}

const Engine* closed_form_of(const Scenario& scenario) {
  if (scenario.closed_form.empty()) return nullptr;
  const Engine* closed_form = Catalog<Engine>::find(scenario.closed_form);
  if (closed_form != nullptr) return closed_form;
  throw std::logic_error(scenario.name + ": unknown closed form \"" + scenario.closed_form + "\"");
}

Case case_of(const Scenario& scenario, const std::string& label, const Parameters& changes) {
  const Parameters parameters = complete(scenario, changes);
  return {.scenario = &scenario,
          .variant = label,
          .parameters = parameters,
          .scene = std::make_shared<const Scene>(scenario.scene(parameters)),
          .closed_form = closed_form_of(scenario)};
}

const Scenario& find_scenario(const std::string& name) { return find_entry<Scenario>("scenario", name); }

std::vector<Case> all_variants(const Scenario& scenario) {
  std::vector<Case> cases;
  for (const Variant& variant : scenario.variants) cases.push_back(case_of(scenario, variant.label, variant.changes));
  return cases;
}

}  // namespace

std::pair<std::string, std::string> split(std::string_view text, char mark) {
  const auto position = text.find(mark);
  if (position == std::string_view::npos) return {std::string(text), ""};
  return {std::string(text.substr(0, position)), std::string(text.substr(position + 1))};
}

std::vector<std::string> split_at_commas(std::string_view text) {
  std::vector<std::string> all;
  while (!text.empty()) {
    all.push_back(split(text, ',').first);
    text.remove_prefix(std::min(text.size(), all.back().size() + 1));
  }
  return all;
}

std::pair<std::string, std::string> parse_assignment(const std::string& context, const std::string& text) {
  auto both = split(text, '=');
  if (!both.first.empty() && !both.second.empty()) return both;
  throw std::invalid_argument(fmt::format("{}: \"{}\" should read key=value", context, text));
}

std::optional<int> parse_integer(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

double parse_number(std::string_view what, std::string_view text) {
  const auto [numerator, denominator] = split(text, '/');
  if (denominator.empty()) return parse_decimal(what, text);
  const double divisor = parse_decimal(what, denominator);
  if (divisor == 0) throw std::invalid_argument(std::string(what) + ": \"" + std::string(text) + "\" divides by zero");
  return parse_decimal(what, numerator) / divisor;
}

double parse_dt(std::string_view text) {
  const double dt = parse_number("--dt", text);
  if (dt > 0 && dt <= 1) return dt;
  throw std::invalid_argument("--dt: \"" + std::string(text) + "\" must be above 0 and at most 1 s");
}

std::vector<Case> catalog_cases(std::string_view word) {
  const auto [name, rest] = split(word, ':');
  const Scenario& scenario = find_scenario(name);
  if (rest.empty()) return all_variants(scenario);
  for (const Variant& variant : scenario.variants) {
    if (variant.label == rest) return {case_of(scenario, variant.label, variant.changes)};
  }
  if (rest.find('=') == std::string::npos) {
    std::vector<std::string> labels;
    for (const Variant& variant : scenario.variants) labels.push_back(variant.label);
    throw std::invalid_argument(name + ": " + unknown("variant", rest, labels) + " Or write parameter=value.");
  }
  Parameters changes;
  for (const std::string& piece : split_at_commas(rest)) {
    const auto [key, value] = parse_assignment(name, piece);
    changes[key] = parse_number(fmt::format("{}: {}", name, key), value);
  }
  return {case_of(scenario, rest, changes)};
}

Case catalog_case(std::string_view word) {
  const auto [name, rest] = split(word, ':');
  return rest.empty() ? case_of(find_scenario(name), "", {}) : catalog_cases(word).front();
}

std::vector<Case> default_cases(bool all) {
  std::vector<Case> cases;
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    if (!all && !scenario->canonical) continue;
    for (Case& one : all_variants(*scenario)) cases.push_back(std::move(one));
  }
  return cases;
}

}  // namespace plumb
