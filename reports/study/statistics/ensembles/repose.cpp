// A block of grains whose sides fall off, and the angle at which the rest stands.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reports/study/statistics/ensemble.h"
#include "reports/study/statistics/ensembles/grains.h"

namespace plumb::ensembles::repose {
namespace {

constexpr double friction = 0.5;
constexpr double half_width = 1;  // m, of the platform: what rolls beyond its edges is gone
constexpr int count = 240;        // grains, poured at once
constexpr double duration = 4;    // s, after which the rest stands
const Grains grains{.radius = 0.035, .spread = 0.3, .surface = surface(friction, 0)};

// The platform is of fixed grains, at random places: on a smooth one they would roll away, and on a regular one lie as
// in a crystal.
Scene block(Random& random) {
  Scene scene{.name = "repose", .about = "A block of grains falls apart on a rough platform.", .duration = duration};
  Body platform{.name = "platform", .type = BodyType::fixed};
  const double most = grains.radius * (1 + grains.spread);
  for (double x = -half_width; x <= half_width; x += random.between(1, 3) * grains.radius) {
    const double radius = grains.radius * random.between(1 - grains.spread, 1 + grains.spread);
    platform.shapes.push_back(
        {.geometry = Circle{.radius = radius, .center = {x, -random.between(1, 2) * most}}, .surface = grains.surface});
  }
  // What falls off the platform lies on the ground, far below.
  platform.shapes.push_back({.geometry = HalfSpace{.offset = -1.2}, .surface = grains.surface});
  scene.bodies.push_back(platform);
  grains.pour(scene, random, 2 * half_width, count);
  return scene;
}

// Degrees: the slope of a line through the highest grains of columns, on both sides together.
double angle_of(std::span<const BodyState> states) {
  constexpr int columns = 8;  // on each side
  constexpr double column = half_width / columns;
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (int i = -columns; i < columns; ++i) {
    double top = 0, at = 0;
    for (const BodyState& one : states.subspan(1)) {
      if (std::floor(one.position.x / column) != i || one.position.y < top) continue;
      top = one.position.y;
      at = std::abs(one.position.x);
    }
    if (top == 0) continue;
    ++n;
    x += at;
    y += top;
    xx += at * at;
    xy += at * top;
  }
  return n < columns ? 0 : -std::atan((n * xy - x * y) / (n * xx - x * x)) / degree;
}

// At the end.
double angle_of(EnsembleRun& run, const Scene& scene) {
  double angle = 0;
  run.watch(scene, [&](double time, std::span<const BodyState> states) {
    if (time > duration - run.dt() / 2) angle = angle_of(states);
    return true;
  });
  return angle;
}

std::vector<EnsembleDraw> draws(EnsembleRun& run, std::uint64_t seed) {
  Random random(seed);
  Scene scene = block(random);
  const double rough = angle_of(run, scene);
  for (Body& body : scene.bodies) {
    for (Shape& shape : body.shapes) shape.surface = surface(0, 0);
  }
  return {{rough, rough - angle_of(run, scene)}};
}

// Discs that flow steadily resist shear as with a coefficient of .26 for mu = .5, and of .11 without any friction (F.
// da Cruz et al., Phys. Rev. E 72, 2005). They roll over each other, so that they do not stand steeper than a block can
// lie, arctan mu. A heap of so few grains on a platform of pegs stands by some degrees steeper than a large one: not so
// the difference to the same heap without friction.
constexpr double flowing = 0.26;
constexpr double frictionless = 0.11;

const Catalog<Ensemble>::Entry entry{
    {.name = "repose",
     .question = "Does a heap stand at an angle that its grains' friction can hold?",
     .dt = 1.0 / 120,
     .runs = 14,
     .large = 280,
     .statistics = {{.name = "angle of repose",
                     .unit = "deg",
                     .low = std::atan(flowing) / degree,
                     .high = std::atan(friction) / degree,
                     .resolution = 7,
                     .source = "from arctan .26, steady flow (da Cruz et al. 2005), to arctan mu"},
                    {.name = "steeper than without friction",
                     .unit = "deg",
                     .low = (std::atan(flowing) - std::atan(frictionless)) / degree,
                     .high = (std::atan(friction) - std::atan(frictionless)) / degree,
                     .resolution = 8,
                     .source = "the same less arctan .11, frictionless discs (da Cruz et al. 2005)"}},
     .draws = draws,
     .control = [] { return *Catalog<Control>::find("frictionless"); }}};

}  // namespace
}  // namespace plumb::ensembles::repose
