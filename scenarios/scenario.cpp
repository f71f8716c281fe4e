#include "scenarios/scenario.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "scenarios/scene/nearest.h"

namespace plumb {
namespace {

struct NameAndUnit {
  const char* name;
  const char* unit;
};

NameAndUnit name_and_unit(Quantity quantity) {
  switch (quantity) {
    case Quantity::x:
      return {"x", "m"};
    case Quantity::y:
      return {"y", "m"};
    case Quantity::angle:
      return {"angle", "rad"};
    case Quantity::vx:
      return {"vx", "m/s"};
    case Quantity::vy:
      return {"vy", "m/s"};
    case Quantity::speed:
      return {"speed", "m/s"};
    case Quantity::angular_velocity:
      return {"angularVelocity", "rad/s"};
    case Quantity::energy:
      return {"energy", "J"};
    case Quantity::momentum_x:
      return {"momentumX", "kg m/s"};
    case Quantity::momentum_y:
      return {"momentumY", "kg m/s"};
    case Quantity::angular_momentum:
      return {"angularMomentum", "kg m^2/s"};
    case Quantity::speed_spread:
      return {"speedSpread", "1"};
    case Quantity::load:
      return {"load", "N"};
    case Quantity::energy_rise:
      return {"energyRise", "J"};
    case Quantity::landing:
      return {"landing", "s"};
    case Quantity::apex:
      return {"apex", "m"};
  }
  return {"", ""};
}

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

const char* name_of(Quantity quantity) { return name_and_unit(quantity).name; }
const char* unit_of(Quantity quantity) { return name_and_unit(quantity).unit; }

const char* name_of(Relation relation) {
  switch (relation) {
    case Relation::equal:
      return "equal";
    case Relation::at_least:
      return "at least";
    case Relation::at_most:
      return "at most";
  }
  return "";
}

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
