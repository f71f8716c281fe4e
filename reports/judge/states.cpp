#include "reports/judge/states.h"

#include <algorithm>
#include <cmath>

#include "scenarios/scene/vec.h"

namespace plumb {

bool is_still(const BodyState& state) {
  return length(state.velocity) <= still_speed && std::abs(state.angular_velocity) <= still_spin;
}

double still_bodies(const Scene& scene, std::span<const BodyState> states) {
  double count = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (scene.bodies[i].type == BodyType::dynamic && is_still(states[i])) ++count;
  }
  return count;
}

bool has_something_to_rest_on(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const Body& body) { return body.type == BodyType::fixed && !body.shapes.empty(); });
}

std::optional<double> time_to_rest(const Scene& scene, const Trace& trace) {
  if (!has_something_to_rest_on(scene)) return std::nullopt;
  const auto all_still = [&](std::size_t moment) {
    const auto states = trace.states(moment);
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (scene.bodies[i].type == BodyType::dynamic && !is_still(states[i])) return false;
    }
    return true;
  };
  std::size_t first = trace.size();
  while (first > 0 && all_still(first - 1)) --first;
  if (first == trace.size()) return std::nullopt;
  return trace.time(first);
}

double fastest_speed(const Scene& scene, std::span<const BodyState> states) {
  double fastest = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (scene.bodies[i].type == BodyType::dynamic) fastest = std::max(fastest, length(states[i].velocity));
  }
  return fastest;
}

PoseDifference pose_difference(const Scene& scene, std::span<const BodyState> a, std::span<const BodyState> b) {
  PoseDifference squares;
  double count = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].type != BodyType::dynamic) continue;
    const Vec moved = a[i].position - b[i].position;
    const double turned = a[i].angle - b[i].angle;
    squares.position += dot(moved, moved);
    squares.angle += turned * turned;
    ++count;
  }
  if (count == 0) return {};
  return {std::sqrt(squares.position / count), std::sqrt(squares.angle / count)};
}

std::vector<PoseDifference> pose_differences(const Scene& scene, const Trace& a, const Trace& b, double until) {
  std::vector<PoseDifference> differences;
  if (b.size() == 0) return differences;
  const double end = std::min(until, b.times().back() * (1 + 1e-12));
  std::vector<BodyState> of_b(scene.bodies.size());
  for (std::size_t moment = 0; moment < a.size() && a.time(moment) <= end; ++moment) {
    for (std::size_t i = 0; i < of_b.size(); ++i) of_b[i] = b.state_at(i, a.time(moment));
    differences.push_back(pose_difference(scene, a.states(moment), of_b));
  }
  return differences;
}

}  // namespace plumb
