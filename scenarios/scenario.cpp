#include "scenarios/scenario.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "scenarios/scene/nearest.h"

namespace plumb {
namespace {

void check_value(const Scenario& scenario, const Parameter& parameter, double value) {
  const bool inside = value >= parameter.min && value <= parameter.max;  // false for NaN
  const bool fractional = parameter.whole && value != std::floor(value);
  if (inside && !fractional) return;
  std::ostringstream what;
  what << scenario.name << ": " << parameter.name << " = " << value;
  if (fractional) {
    what << " must be a whole number";
  } else {
    what << " is out of range, must be " << parameter.min << " ... " << parameter.max;
    if (!parameter.unit.empty()) what << ' ' << parameter.unit;
  }
  throw std::invalid_argument(what.str());
}

}  // namespace

Parameters complete(const Scenario& scenario, const Parameters& changes) {
  Parameters values;
  std::vector<std::string> names;
  for (const Parameter& parameter : scenario.parameters) {
    values[parameter.name] = parameter.value;
    names.push_back(parameter.name);
  }
  for (const auto& [name, value] : changes) {
    const auto known = values.find(name);
    if (known == values.end()) throw std::invalid_argument(scenario.name + ": " + unknown("parameter", name, names));
    known->second = value;
  }
  for (const Parameter& parameter : scenario.parameters) check_value(scenario, parameter, values[parameter.name]);
  return values;
}

}  // namespace plumb
