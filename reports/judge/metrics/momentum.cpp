#include <algorithm>
#include <cmath>
#include <variant>

#include "reports/judge/conserved.h"
#include "reports/judge/metric.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"

namespace plumb::metrics::momentum {
namespace {

// Whether a scene's bodies feel nothing from outside but gravity: nothing immovable to meet or to hang on, no force
// whose impulse depends on the motion.
bool feels_gravity_only(const Scene& scene) {
  const auto moves_freely = [](const Body& body) {
    return body.type == BodyType::dynamic && body.linear_damping == 0 && body.angular_damping == 0;
  };
  const auto is_internal = [](const Force& force) {
    if (const auto* attraction = std::get_if<Attraction>(&force)) return attraction->mutual;
    const auto* spring = std::get_if<Spring>(&force);
    return spring != nullptr && spring->a.has_value();
  };
  return std::all_of(scene.bodies.begin(), scene.bodies.end(), moves_freely) &&
         std::all_of(scene.forces.begin(), scene.forces.end(), is_internal);
}

bool has_one_gravity_scale(const Scene& scene) {
  return std::all_of(scene.bodies.begin(), scene.bodies.end(),
                     [&](const Body& body) { return body.gravity_scale == scene.bodies.front().gravity_scale; });
}

bool may_rotate(const Scene& scene) {
  return std::none_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) { return body.fixed_rotation; });
}

// p(t) = p(0) + t sum m s g.
std::optional<double> linear_error(const MetricContext& context) {
  if (!feels_gravity_only(context.scene)) return std::nullopt;
  const Conserved conserved(context.scene);
  double pulled = 0;
  for (std::size_t i = 0; i < context.scene.bodies.size(); ++i) {
    pulled += conserved.masses()[i].mass * context.scene.bodies[i].gravity_scale;
  }
  const Vec start = conserved.momentum(initial_states(context.scene)).linear;
  double largest = 0;
  for (std::size_t i = 0; i < context.trace.size(); ++i) {
    const Vec expected = start + context.trace.time(i) * pulled * context.scene.gravity;
    largest = std::max(largest, length(conserved.momentum(context.trace.states(i)).linear - expected));
  }
  return largest;
}

// Gravity turns the whole about the origin as if its mass were in its centre, which falls as r(t) = r0 + v0 t + s g
// t^2/2:
//   L(t) = L(0) + M s int r x g dt = L(0) + M s (r0 x g t + v0 x g t^2/2).
// It needs one gravity scale s, and bodies that are free to turn.
std::optional<double> angular_error(const MetricContext& context) {
  const Scene& scene = context.scene;
  if (!feels_gravity_only(scene) || !has_one_gravity_scale(scene) || !may_rotate(scene)) return std::nullopt;
  const Conserved conserved(scene);
  const std::vector<BodyState> states = initial_states(scene);
  const Momentum start = conserved.momentum(states);
  Vec first;  // M r0
  for (std::size_t i = 0; i < states.size(); ++i) first = first + conserved.masses()[i].mass * states[i].position;
  const Vec pull = (scene.bodies.empty() ? 0 : scene.bodies.front().gravity_scale) * scene.gravity;
  double largest = 0;
  for (std::size_t i = 0; i < context.trace.size(); ++i) {
    const double t = context.trace.time(i);
    const double expected = start.angular + cross(first, pull) * t + cross(start.linear, pull) * t * t / 2;
    largest = std::max(largest, std::abs(conserved.momentum(context.trace.states(i)).angular - expected));
  }
  return largest;
}

const Catalog<Metric>::Entry linear{
    {.name = "momentum_error",
     .unit = "kg m/s",
     .definition = "largest deviation of the momentum from its start plus gravity's impulse; where nothing else acts",
     .measure = linear_error}};
const Catalog<Metric>::Entry angular{
    {.name = "angular_momentum_error",
     .unit = "kg m^2/s",
     .definition = "largest deviation of the angular momentum about the world's origin from its start plus gravity's "
                   "turning impulse; where nothing else acts",
     .measure = angular_error}};

}  // namespace
}  // namespace plumb::metrics::momentum
