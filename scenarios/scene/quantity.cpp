#include "scenarios/scene/quantity.h"

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

}  // namespace

const char* name_of(Quantity quantity) { return name_and_unit(quantity).name; }
const char* unit_of(Quantity quantity) { return name_and_unit(quantity).unit; }

bool of_whole_scene(Quantity quantity) {
  return quantity == Quantity::energy || quantity == Quantity::momentum_x || quantity == Quantity::momentum_y ||
         quantity == Quantity::angular_momentum;
}

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

}  // namespace plumb
