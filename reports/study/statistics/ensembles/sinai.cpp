// A disc in a square around a round scatterer: the billiard that Sinai proved ergodic (Russ. Math. Surv. 25, 1970).

#include <cmath>
#include <numbers>

#include "reports/study/statistics/ensemble.h"
#include "scenarios/parts.h"
#include "scenarios/random.h"

namespace plumb::ensembles::sinai {
namespace {

constexpr int discs = 31;          // at once: each has a layer of its own, so that they do not meet
constexpr double half = 1;         // m, of the square's side
constexpr double scatterer = 0.4;  // m, radius
constexpr double radius = 0.05;    // m
constexpr double near = 0.75;      // m, from the middle: what counts as near the scatterer
constexpr double speed = 4;        // m/s
constexpr double duration = 20;    // s: some sixty impacts

Scene table(Random& random) {
  const Surface elastic = surface(0, 1);
  Scene scene{.name = "sinai",
              .about = "Discs bounce in a square around a round scatterer and do not meet.",
              .gravity = {0, 0},
              .duration = duration};
  const std::pair<const char*, Vec> walls[] = {
      {"floor", {0, 1}}, {"lid", {0, -1}}, {"left", {1, 0}}, {"right", {-1, 0}}};
  for (const auto& [name, normal] : walls)
    scene.bodies.push_back(half_space(name, {.normal = normal, .offset = -half}, elastic));
  scene.bodies.push_back(fixed(disc("scatterer", {}, scatterer, elastic)));
  for (int i = 0; i < discs; ++i) {
    // All start in one corner, so that where they are later is no echo of where they began.
    Body one =
        disc("disc " + std::to_string(i + 1), {random.between(0.7, 0.9), random.between(0.7, 0.9)}, radius, elastic);
    const double direction = random.between(0, 2 * std::numbers::pi);
    one.velocity = {speed * std::cos(direction), speed * std::sin(direction)};
    one.layers = std::uint32_t{1} << i;
    scene.bodies.push_back(one);
  }
  return scene;
}

// Time averages of each disc, after the first fifth of the run.
std::vector<EnsembleDraw> draws(EnsembleRun& run, std::uint64_t seed) {
  Random random(seed);
  std::vector<EnsembleDraw> found(discs, EnsembleDraw(4, 0));
  double moments = 0;
  run.watch(table(random), [&](double time, std::span<const BodyState> states) {
    if (time < duration / 5) return true;
    ++moments;
    for (std::size_t i = 0; i < discs; ++i) {
      const auto [position, angle, velocity, angular_velocity] = states[states.size() - discs + i];
      const double squared = velocity.x * velocity.x + velocity.y * velocity.y;
      found[i][0] += std::hypot(position.x, position.y) < near ? 1 : 0;
      found[i][1] += position.x > 0 ? 1 : 0;
      found[i][2] += squared > 0 ? velocity.x * velocity.x / squared : 0;
      found[i][3] += std::sqrt(squared) / speed;
    }
    return true;
  });
  for (EnsembleDraw& draw : found) {
    for (double& value : draw) value /= moments;
  }
  return found;
}

// The share of the area that the disc's centre can reach.
double near_share() {
  const double inner = scatterer + radius;
  const double side = 2 * (half - radius);
  return std::numbers::pi * (near * near - inner * inner) / (side * side - std::numbers::pi * inner * inner);
}

// Liouville's measure is uniform in place and direction. An engine may spend up to a step of 1/240 s at each impact;
// the free flight between two takes pi area/perimeter/speed = .22 s on average. That is 1/53 of the time, at the walls
// or at the scatterer: as much of the share, either way.
const Catalog<Ensemble>::Entry entry{
    {.name = "sinai",
     .question = "Does a ball in Sinai's billiard spend its time where the area is, at constant speed?",
     .dt = 1.0 / 240,
     .runs = 16,
     .large = 320,
     .statistics = {{.name = "time near the scatterer",
                     .low = near_share() * (1 - 1.0 / 53),
                     .high = near_share() * (1 + 1.0 / 53),
                     .resolution = 0.03,
                     .source = "the share of the area (ergodic), within the share of steps in which an impact is"},
                    {.name = "time in the right half",
                     .low = 0.5,
                     .high = 0.5,
                     .resolution = 0.03,
                     .source = "symmetry, once the start is forgotten"},
                    {.name = "vx^2/v^2", .low = 0.5, .high = 0.5, .resolution = 0.03, .source = "symmetry"},
                    {.name = "speed / initial speed",
                     .low = 0.9999,
                     .high = 1.0001,
                     .resolution = 0.002,
                     .source = "elastic; 1e-4 for a hundred impacts in single precision"}},
     .draws = draws,
     .control = [] { return *Catalog<Control>::find("no-restitution"); }}};

}  // namespace
}  // namespace plumb::ensembles::sinai
