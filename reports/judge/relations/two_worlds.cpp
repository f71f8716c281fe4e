#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "reports/judge/poses.h"
#include "scenarios/catalog.h"
#include "scenarios/images.h"

namespace plumb::relations::two_worlds {
namespace {

// Two scenes that share nothing are each as alone. The copy stands beside the scene, and the layers of its bodies are
// others, so that even half-spaces of one mean nothing to the other. Where an engine iterates over all contacts, those
// of the other world stand between, in no row with ours: the order may change, and with it what its iterations leave.
// The copy is shifted, and rounded as such.
struct Layers {
  std::uint32_t mask = 0;
  int apart = 0;
};

std::optional<Layers> layers_of(const Scene& scene) {
  constexpr std::uint32_t all = ~std::uint32_t{0};
  constexpr std::uint32_t lower = 0xFFFF;
  const bool fit = std::all_of(scene.bodies.begin(), scene.bodies.end(),
                               [](const Body& body) { return body.layers == all || (body.layers & ~lower) == 0; });
  if (!fit) return std::nullopt;
  return Layers{lower, 16};
}

Vec beside(const Scene& scene) { return {5.3 * extent_of(scene), 1.9 * extent_of(scene)}; }

std::string excludes(const Scene& scene, const Stepping&) {
  if (!layers_of(scene)) return "its layers leave none for a second world";
  for (const Force& force : scene.forces) {
    if (std::holds_alternative<Attraction>(force)) return "an attraction reaches the second world";
  }
  return "";
}

RelationCheck compare(const RelationRun& run, std::span<const RelationRun> images) {
  const auto residue = residue_of(run.stepping);
  const RelationRun& both = images.front();
  const RelationCheck first = compare_congruent(run, both, {}, 0, residue);
  return worse(first, compare_congruent(run, both, {.shift = beside(run.scene)}, run.scene.bodies.size(), residue));
}

const Catalog<MetamorphicRelation>::Entry entry{
    {.name = "two_worlds",
     .unit = "m",
     .definition = "a scene and a copy beside it that never meets it move each as alone, but for round-off and what a "
                   "solver's stated iterations leave",
     .excludes = excludes,
     .images = [](const Scene& scene, const Trace&, double dt) -> std::vector<Image> {
       const Layers layers = layers_of(scene).value();
       return {{doubled(scene, beside(scene), layers.mask, layers.apart), dt}};
     },
     .compare = compare}};

}  // namespace
}  // namespace plumb::relations::two_worlds
