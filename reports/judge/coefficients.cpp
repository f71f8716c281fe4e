#include "reports/judge/coefficients.h"

#include <algorithm>
#include <limits>

namespace plumb {

double Coefficients::sticking(std::size_t a, std::size_t b) const {
  double largest = 0;
  for (const Shape& one : scene_.bodies[a].shapes) {
    for (const Shape& other : scene_.bodies[b].shapes) {
      largest = std::max(largest, mixed_static_friction(scene_.mixing, one.surface, other.surface));
    }
  }
  return largest;
}

double Coefficients::sliding(std::size_t a, std::size_t b) const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Shape& one : scene_.bodies[a].shapes) {
    for (const Shape& other : scene_.bodies[b].shapes) {
      smallest = std::min(smallest, mixed_dynamic_friction(scene_.mixing, one.surface, other.surface));
    }
  }
  return smallest;
}

}  // namespace plumb
