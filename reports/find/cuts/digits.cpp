#include "reports/find/shrink.h"
#include "scenarios/catalog.h"

namespace plumb::cuts::digits {
namespace {

// Of all numbers, then of each body's.
std::vector<Scene> rounder(const Scene& scene, const Failure&) {
  std::vector<Scene> all;
  const std::size_t bodies = scene.bodies.size();
  for (const int digits : {1, 2, 3}) {
    if (auto one = with_digits(scene, digits)) all.push_back(std::move(*one));
    for (std::size_t i = 0; i < bodies && bodies > 1; ++i) {
      if (auto one = with_digits(scene, digits, i)) all.push_back(std::move(*one));
    }
  }
  return all;
}

const Catalog<Cut>::Entry entry{{.name = "fewer digits", .order = 7, .simpler = rounder}};

}  // namespace
}  // namespace plumb::cuts::digits
