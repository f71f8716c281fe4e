#include <algorithm>
#include <vector>

#include "reports/judge/invariant.h"
#include "reports/judge/overlap.h"
#include "reports/judge/roundings.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/mass.h"

// A pair may stand off by the gap that the method states, as deep as the scene begins with, and by the way that two
// bodies approach each other while an impact waits to be noticed: lag h (V_a + V_b), V the largest speed of any point
// of a body so far; how fast a method pushes out what was pressed in is its own affair.
namespace plumb::invariants::overlap {
namespace {

double reach_of(const Body& body) {
  double reach = 0;
  const Vec center = mass_of(body).center;
  for (const Shape& shape : body.shapes) {
    const Outline outline = outline_of(shape.geometry, center);
    for (const Vec point : outline.points) reach = std::max(reach, length(point) + outline.radius);
  }
  return reach;
}

std::optional<InvariantCheck> check(const InvariantContext& context) {
  const auto& [scene, trace, stepping] = context;
  if (scene.bodies.size() < 2) return std::nullopt;
  const Overlap overlap(scene);
  const double nu = roundings(trace, stepping);
  const double begun = overlap.deepest(trace.states(0)).depth;
  std::vector<double> reaches;
  for (const Body& body : scene.bodies) reaches.push_back(reach_of(body));
  std::vector<double> fastest(scene.bodies.size());
  std::vector<double> farthest(scene.bodies.size());
  Worst worst;
  for (std::size_t moment = 0; moment < trace.size(); ++moment) {
    const auto states = trace.states(moment);
    for (std::size_t i = 0; i < states.size(); ++i) {
      fastest[i] = std::max(fastest[i], length(states[i].velocity) + reaches[i] * std::abs(states[i].angular_velocity));
      farthest[i] = std::max(farthest[i], length(states[i].position) + reaches[i] * (1 + std::abs(states[i].angle)));
    }
    for (const Overlapping& pair : overlap.all(states)) {
      const double rounded =
          farthest[pair.a] + farthest[pair.b] + trace.times().back() / 2 * (fastest[pair.a] + fastest[pair.b]);
      const double late = stepping.impact_lag * stepping.h * (fastest[pair.a] + fastest[pair.b]);
      worst.see(pair.depth, stepping.gap + begun + late + nu * rounded, trace.time(moment),
                [&] { return pair_name(context.scene, pair.a, pair.b); });
    }
  }
  return worst.result();
}

const Catalog<Invariant>::Entry entry{
    {.name = "overlap",
     .unit = "m",
     .definition = "bodies reach into each other by no more than the gap stated and the way of a hit noticed late",
     .check = check}};

}  // namespace
}  // namespace plumb::invariants::overlap
