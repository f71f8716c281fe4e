#include "reference/simulation.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "scenarios/scene/nearest.h"

namespace plumb {
namespace {

std::string prefix(const Engine& engine, const Option& option) { return engine.name + ": option " + option.key + ": "; }

void check_choice(const Engine& engine, const Option& option, const std::string& value) {
  std::vector<std::string> choices;
  for (const auto& [choice, about] : option.choices) {
    if (choice == value) return;
    choices.push_back(choice);
  }
  throw std::invalid_argument(prefix(engine, option) + unknown("choice", value, choices));
}

void check_number(const Engine& engine, const Option& option, std::string_view value) {
  double number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  const bool read = error == std::errc{} && end == value.data() + value.size();
  const bool fits = !option.whole || number == std::trunc(number);
  if (read && fits && number >= option.min && number <= option.max) return;
  std::ostringstream what;
  what << prefix(engine, option) << '"' << value << "\" must be a " << (option.whole ? "whole number, " : "number, ")
       << option.min << " ... " << option.max;
  throw std::invalid_argument(what.str());
}

}  // namespace

const char* name_of(ExecutionKind execution) {
  switch (execution) {
    case ExecutionKind::native:
      return "native";
    case ExecutionKind::webassembly:
      return "WebAssembly";
    case ExecutionKind::jit:
      return "JIT";
    case ExecutionKind::interpreted:
      return "interpreted";
    case ExecutionKind::not_stated:
      return "not stated";
  }
  return "";
}

void Simulation::drive(std::size_t, Vec) { throw std::logic_error("this engine can't drive kinematic bodies"); }

double Simulation::valid_until() const { return std::numeric_limits<double>::infinity(); }

Settings complete(const Engine& engine, const Settings& given) {
  Settings values;
  std::vector<std::string> keys;
  for (const Option& option : engine.options) {
    values[option.key] = option.value;
    keys.push_back(option.key);
  }
  for (const auto& [key, value] : given) {
    const auto known = values.find(key);
    if (known == values.end()) throw std::invalid_argument(engine.name + ": " + unknown("option", key, keys));
    known->second = value;
  }
  for (const Option& option : engine.options) {
    if (option.choices.empty()) {
      check_number(engine, option, values[option.key]);
    } else {
      check_choice(engine, option, values[option.key]);
    }
  }
  return values;
}

}  // namespace plumb
