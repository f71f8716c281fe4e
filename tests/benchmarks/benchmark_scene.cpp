#include "benchmark_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "reports/judge/overlap.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

namespace plumb::benchmarks {
namespace {

// Fractions of the smallest body's size.

// A body that is half of its size deep in another comes out on the other side. If the mean is half of that, contacts no
// longer hold bodies apart.
constexpr double largest_overlap = 0.25;

// Large nets stretch in any engine that does not solve them exactly. If hinged bodies are farther apart than one of
// them is wide, the net is torn.
constexpr double largest_gap = 1;

// A body that has moved by half of its size relative to its support lies on the next body, or on the row below.
constexpr double largest_slip = 0.5;

std::string non_finite(std::span<const BodyState> states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    const BodyState& s = states[i];
    if (!std::isfinite(s.position.x + s.position.y + s.angle + s.velocity.x + s.velocity.y + s.angular_velocity)) {
      return fmt::format("the state of body {} is not finite", i);
    }
  }
  return "";
}

std::string escaped(const SceneSetup& setup, std::span<const BodyState> states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (setup.scene.bodies[i].type != BodyType::dynamic) continue;
    if (length(states[i].position - setup.center) > setup.reach) return fmt::format("body {} has left the scene", i);
  }
  return "";
}

std::string fallen(const SceneSetup& setup, std::span<const BodyState> states) {
  const auto& bodies = setup.scene.bodies;
  for (const auto [above, below] : setup.supports) {
    const Vec was = bodies[above].position - bodies[below].position;
    const Vec is = states[above].position - states[below].position;
    if (length(is - was) > largest_slip * setup.size)
      return fmt::format("body {} has fallen off body {}", above, below);
  }
  return "";
}

// Where a point of a body is that was at `anchor` at the start; both in the world frame.
Vec moved_point(const Body& body, const BodyState& state, Vec anchor) {
  return state.position + rotated(anchor - body.position, state.angle - body.angle);
}

std::string open_hinge(const SceneSetup& setup, std::span<const BodyState> states) {
  const auto& bodies = setup.scene.bodies;
  double widest = largest_gap * setup.size;
  std::string reason;
  for (const Joint& joint : setup.scene.joints) {
    const auto* hinge = std::get_if<Revolute>(&joint);
    if (hinge == nullptr) continue;
    const Vec on_a = moved_point(bodies[hinge->a], states[hinge->a], hinge->anchor);
    const Vec on_b = moved_point(bodies[hinge->b], states[hinge->b], hinge->anchor);
    const double gap = length(on_b - on_a);
    if (gap > widest) {
      widest = gap;
      reason = fmt::format("the hinge of bodies {} and {} is open by {:.3g} m", hinge->a, hinge->b, gap);
    }
  }
  return reason;
}

OverlapDepth depth_of(const std::vector<BodyOverlap>& overlaps) {
  OverlapDepth depth;
  for (const BodyOverlap& one : overlaps) {
    depth.mean += one.depth / static_cast<double>(overlaps.size());
    depth.most = std::max(depth.most, one.depth);
  }
  return depth;
}

}  // namespace

void add_pyramid(SceneSetup& setup, int base, Vec middle) {
  std::vector<Body>& bodies = setup.scene.bodies;
  for (int row = 0; row < base; ++row) {
    const int width = base - row;
    for (int i = 0; i < width; ++i) {
      const std::size_t here = bodies.size();
      bodies.push_back(box("", {middle.x + i - (width - 1) / 2.0, middle.y + row + 0.5}, {1, 1}, surface(0.6, 0)));
      if (row == 0) continue;
      const std::size_t below = here - static_cast<std::size_t>(width) - 1;
      setup.supports.push_back({here, below});
      setup.supports.push_back({here, below + 1});
    }
  }
}

SceneCheck check_scene(const SceneSetup& setup, std::span<const BodyState> states) {
  SceneCheck found{.broken = non_finite(states)};
  if (!found.broken.empty()) return found;
  found.overlap = depth_of(Overlap(setup.scene).all(states));
  for (const auto& check : {escaped, fallen, open_hinge}) {
    found.broken = check(setup, states);
    if (!found.broken.empty()) return found;
  }
  if (found.overlap.mean > largest_overlap * setup.size) {
    found.broken = fmt::format("bodies overlap by {:.3g} m on average", found.overlap.mean);
  }
  return found;
}

}  // namespace plumb::benchmarks
