// Conservation of energy and momentum over a run.
#include <algorithm>
#include <cmath>
#include <variant>

#include "reports/judge/mechanics.h"
#include "reports/judge/metric.h"
#include "reports/judge/observe.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/scene.h"
#include "scenarios/scene/vec.h"

namespace plumb::metrics::conservation {
namespace {

template <class Part>
Metric energy_at_end(const char* name, const char* definition, Part part) {
  return {.name = name,
          .unit = "J",
          .definition = definition,
          .better = Better::neither,
          .measure = [part](const MetricContext& context) -> std::optional<double> {
            return part(Conserved(context.scene).energy(context.trace.states(context.trace.size() - 1)));
          }};
}

const Catalog<Metric>::Entry linear_energy{energy_at_end("kinetic_energy_end", "sum of m v^2/2 at the end",
                                                         [](const Energy& energy) { return energy.linear; })};
const Catalog<Metric>::Entry rotational_energy{energy_at_end("rotational_energy_end", "sum of I w^2/2 at the end",
                                                             [](const Energy& energy) { return energy.rotational; })};
const Catalog<Metric>::Entry potential_energy{
    energy_at_end("potential_energy_end", "potential energy of gravity (-m g.r), springs and attractions at the end",
                  [](const Energy& energy) { return energy.potential; })};

// Work from outside changes the energy without an error.
bool has_outside_work(const Scene& scene) {
  const auto is_constant = [](const Force& force) { return std::holds_alternative<Constant>(force); };
  return std::any_of(scene.forces.begin(), scene.forces.end(), is_constant) ||
         std::any_of(scene.bodies.begin(), scene.bodies.end(), is_carried);
}

template <class Change>
Metric relative_change(const char* name, const char* definition, Better better, Change change) {
  return {.name = name,
          .unit = "1",
          .definition = definition,
          .better = better,
          .measure = [change](const MetricContext& context) -> std::optional<double> {
            const double range = energy_range(context.scene, context.truth);
            if (range == 0 || has_outside_work(context.scene)) return std::nullopt;
            const Conserved conserved(context.scene);
            return change(conserved, context.trace) / range;
          }};
}

double largest_rise(const Conserved& conserved, const Trace& trace) {
  return energy_rise(conserved, trace, trace.size() - 1).value;
}

double drift(const Conserved& conserved, const Trace& trace) {
  return conserved.energy(trace.states(trace.size() - 1)).total() - conserved.energy(trace.states(0)).total();
}

const Catalog<Metric>::Entry rise{relative_change(
    "energy_rise", "largest rise of the total energy above an earlier value, relative to the scene's energy range",
    Better::lower, largest_rise)};
const Catalog<Metric>::Entry change{relative_change(
    "energy_drift", "total energy at the end minus that at the start, relative to the scene's energy range",
    Better::neither, drift)};

// Whether gravity is the only outside influence on a scene's bodies: nothing immovable to touch or to be attached to,
// and no outside force whose impulse depends on the motion.
bool feels_only_gravity(const Scene& scene) {
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
std::optional<double> momentum_error(const MetricContext& context) {
  if (!feels_only_gravity(context.scene)) return std::nullopt;
  const Conserved conserved(context.scene);
  double scaled_mass = 0;
  for (std::size_t i = 0; i < context.scene.bodies.size(); ++i) {
    scaled_mass += conserved.masses()[i].mass * context.scene.bodies[i].gravity_scale;
  }
  const Vec start = conserved.momentum(initial_states(context.scene)).linear;
  double largest = 0;
  for (std::size_t i = 0; i < context.trace.size(); ++i) {
    const Vec expected = start + context.trace.time(i) * scaled_mass * context.scene.gravity;
    largest = std::max(largest, length(conserved.momentum(context.trace.states(i)).linear - expected));
  }
  return largest;
}

// Gravity's torque about the origin is that on a point mass M at the common centre of mass, which falls as
// r(t) = r0 + v0 t + s g t^2/2:
//   L(t) = L(0) + M s int r x g dt = L(0) + M s (r0 x g t + v0 x g t^2/2).
// This needs one gravity scale s, and bodies that are free to rotate.
std::optional<double> angular_momentum_error(const MetricContext& context) {
  const Scene& scene = context.scene;
  if (!feels_only_gravity(scene) || !has_one_gravity_scale(scene) || !may_rotate(scene)) return std::nullopt;
  const Conserved conserved(scene);
  const std::vector<BodyState> states = initial_states(scene);
  const Momentum start = conserved.momentum(states);
  Vec first;  // M r0
  for (std::size_t i = 0; i < states.size(); ++i) first = first + conserved.masses()[i].mass * states[i].position;
  const Vec gravity = (scene.bodies.empty() ? 0 : scene.bodies.front().gravity_scale) * scene.gravity;
  double largest = 0;
  for (std::size_t i = 0; i < context.trace.size(); ++i) {
    const double t = context.trace.time(i);
    const double expected = start.angular + cross(first, gravity) * t + cross(start.linear, gravity) * t * t / 2;
    largest = std::max(largest, std::abs(conserved.momentum(context.trace.states(i)).angular - expected));
  }
  return largest;
}

const Catalog<Metric>::Entry linear_momentum{
    {.name = "momentum_error",
     .unit = "kg m/s",
     .definition = "largest deviation of the momentum from its start plus the impulse of gravity, in scenes where "
                   "nothing else acts",
     .measure = momentum_error}};
const Catalog<Metric>::Entry angular_momentum{
    {.name = "angular_momentum_error",
     .unit = "kg m^2/s",
     .definition = "largest deviation of the angular momentum about the world's origin from its start plus the angular "
                   "impulse of gravity, in scenes where nothing else acts",
     .measure = angular_momentum_error}};

}  // namespace
}  // namespace plumb::metrics::conservation
