#include "collapse.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "reports/judge/overlap.h"
#include "reports/vec.h"

namespace plumb::benchmarks {
namespace {

// Half of a body deep, the shortest way out is through the other side. Where all are half-way there on the mean,
// nothing is held any more.
constexpr double sunk = 0.25;

// Large nets stretch under any engine that does not solve them exactly. Whoever leaves hinged bodies farther apart than
// one of them is wide has no net any more.
constexpr double torn = 1;

// A body that has moved by half of itself against what bears it lies over the next one, or on the row below.
constexpr double fell = 0.5;

std::string not_finite(std::span<const BodyState> states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    const BodyState& s = states[i];
    if (!std::isfinite(s.position.x + s.position.y + s.angle + s.velocity.x + s.velocity.y + s.angular_velocity)) {
      return fmt::format("body {} is nowhere", i);
    }
  }
  return "";
}

std::string escaped(const Start& start, std::span<const BodyState> states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (start.scene.bodies[i].type != BodyType::dynamic) continue;
    if (length(states[i].position - start.center) > start.reach) return fmt::format("body {} has left", i);
  }
  return "";
}

std::string fallen(const Start& start, std::span<const BodyState> states) {
  const auto& bodies = start.scene.bodies;
  for (const auto [above, below] : start.rests) {
    const Vec was = bodies[above].position - bodies[below].position;
    const Vec is = states[above].position - states[below].position;
    if (length(is - was) > fell * start.size) return fmt::format("body {} has fallen from {}", above, below);
  }
  return "";
}

Vec carried(const Body& body, const BodyState& state, Vec anchor) {
  return state.position + rotated(anchor - body.position, state.angle - body.angle);
}

std::string gaping(const Start& start, std::span<const BodyState> states) {
  const auto& bodies = start.scene.bodies;
  double widest = torn * start.size;
  std::string reason;
  for (const Joint& joint : start.scene.joints) {
    const auto* hinge = std::get_if<Revolute>(&joint);
    if (hinge == nullptr) continue;
    const Vec on_a = carried(bodies[hinge->a], states[hinge->a], hinge->anchor);
    const Vec on_b = carried(bodies[hinge->b], states[hinge->b], hinge->anchor);
    const double gap = length(on_b - on_a);
    if (gap > widest) {
      widest = gap;
      reason = fmt::format("the hinge of {} and {} gapes by {:.3g} m", hinge->a, hinge->b, gap);
    }
  }
  return reason;
}

Depth depth_of(const std::vector<BodyOverlap>& overlaps) {
  Depth depth;
  for (const BodyOverlap& one : overlaps) {
    depth.mean += one.depth / static_cast<double>(overlaps.size());
    depth.most = std::max(depth.most, one.depth);
  }
  return depth;
}

}  // namespace

Condition condition(const Start& start, std::span<const BodyState> states) {
  Condition found{.broken = not_finite(states)};
  if (!found.broken.empty()) return found;
  found.overlap = depth_of(Overlap(start.scene).all(states));
  for (const auto& look : {escaped, fallen, gaping}) {
    found.broken = look(start, states);
    if (!found.broken.empty()) return found;
  }
  if (found.overlap.mean > sunk * start.size) {
    found.broken = fmt::format("bodies overlap by {:.3g} m on the mean", found.overlap.mean);
  }
  return found;
}

}  // namespace plumb::benchmarks
