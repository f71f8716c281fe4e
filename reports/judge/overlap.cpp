#include "reports/judge/overlap.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <variant>

#include "reports/vec.h"
#include "scenarios/scene/mass.h"

namespace plumb {

Overlap::Overlap(const Scene& scene) : scene_(scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Vec center = mass_of(scene.bodies[i]).center;
    for (const Shape& shape : scene.bodies[i].shapes) parts_.push_back({i, outline_of(shape.geometry, center)});
  }
  for (const Joint& joint : scene.joints) {
    jointed_.push_back(std::visit([](const auto& of) { return std::minmax(of.a, of.b); }, joint));
  }
  std::sort(jointed_.begin(), jointed_.end());
}

bool Overlap::may_touch(std::size_t a, std::size_t b) const {
  const Body& one = scene_.bodies[a];
  const Body& other = scene_.bodies[b];
  if (a == b || (one.type != BodyType::dynamic && other.type != BodyType::dynamic)) return false;
  if ((one.layers & other.layers) == 0) return false;
  const std::pair<std::size_t, std::size_t> pair = std::minmax(a, b);
  return !std::binary_search(jointed_.begin(), jointed_.end(), pair);
}

std::vector<Overlapping> Overlap::all(std::span<const BodyState> states) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  struct Placed {
    std::size_t body;
    Outline outline;
    Interval x;
  };
  std::vector<Placed> parts;
  for (const Part& part : parts_) {
    const BodyState& state = states[part.body];
    Outline outline = placed(part.outline, state.position, state.angle);
    const Interval x = range_along({1, 0}, outline).value_or(Interval{-infinity, infinity});
    parts.push_back({part.body, std::move(outline), x});
  }
  // From left to right, each part meets those that begin before it ends.
  std::sort(parts.begin(), parts.end(), [](const Placed& a, const Placed& b) { return a.x.low < b.x.low; });
  std::vector<Overlapping> overlaps;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.size() && parts[j].x.low <= parts[i].x.high; ++j) {
      if (!may_touch(parts[i].body, parts[j].body)) continue;
      const double depth = -gap_between(parts[i].outline, parts[j].outline);
      const auto [a, b] = std::minmax(parts[i].body, parts[j].body);
      if (depth > 0) overlaps.push_back({a, b, depth});
    }
  }
  return overlaps;
}

double Overlap::gap(std::size_t a, std::size_t b, std::span<const BodyState> states) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Part& one : parts_) {
    if (one.body != a) continue;
    const Outline outline = placed(one.outline, states[a].position, states[a].angle);
    for (const Part& other : parts_) {
      if (other.body != b) continue;
      nearest = std::min(nearest, gap_between(outline, placed(other.outline, states[b].position, states[b].angle)));
    }
  }
  return nearest;
}

Overlapping Overlap::deepest(std::span<const BodyState> states) const {
  const std::vector<Overlapping> overlaps = all(states);
  const auto deeper = [](const Overlapping& one, const Overlapping& other) { return one.depth < other.depth; };
  return overlaps.empty() ? Overlapping{} : *std::max_element(overlaps.begin(), overlaps.end(), deeper);
}

}  // namespace plumb
