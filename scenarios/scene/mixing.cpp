#include <algorithm>
#include <cmath>

#include "scenarios/scene/scene.h"

namespace plumb {
namespace {

double mixed(FrictionMixing rule, double a, double b) {
  switch (rule) {
    case FrictionMixing::geometric:
      return std::sqrt(a * b);
    case FrictionMixing::pythagorean:
      return std::sqrt(a * a + b * b);
    case FrictionMixing::average:
      return (a + b) / 2;
    case FrictionMixing::min:
      return std::min(a, b);
    case FrictionMixing::max:
      return std::max(a, b);
    case FrictionMixing::multiply:
      return a * b;
  }
  return 0;
}

}  // namespace

double mixed_static_friction(const Mixing& mixing, const Surface& a, const Surface& b) {
  return mixed(mixing.friction, a.static_friction, b.static_friction);
}

double mixed_dynamic_friction(const Mixing& mixing, const Surface& a, const Surface& b) {
  return mixed(mixing.friction, a.dynamic_friction, b.dynamic_friction);
}

double mixed_restitution(const Mixing& mixing, const Surface& a, const Surface& b) {
  switch (mixing.restitution) {
    case RestitutionMixing::max:
      return std::max(a.restitution, b.restitution);
    case RestitutionMixing::min:
      return std::min(a.restitution, b.restitution);
    case RestitutionMixing::average:
      return (a.restitution + b.restitution) / 2;
    case RestitutionMixing::multiply:
      return a.restitution * b.restitution;
  }
  return 0;
}

}  // namespace plumb
