#include "reports/run/scene_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/scene_facts.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/overlap.h"
#include "scenarios/scene/joints.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

// Of one kind; more would hide what else there is.
constexpr std::size_t most_warnings = 5;

// Adds at most so many warnings, and how many more there are.
class Warnings {
 public:
  explicit Warnings(std::vector<std::string>& all) : all_(all) {}
  Warnings(const Warnings&) = delete;
  Warnings& operator=(const Warnings&) = delete;
  ~Warnings() {
    if (count_ > most_warnings) all_.push_back(fmt::format("and {} more like that", count_ - most_warnings));
  }
  void add(const std::string& text) {
    if (++count_ <= most_warnings) all_.push_back(text);
  }

 private:
  std::vector<std::string>& all_;
  std::size_t count_ = 0;
};

std::string place_of(const Scene& scene, std::size_t body) {
  return fmt::format("bodies[{}] (\"{}\")", body, scene.bodies[body].name);
}

// Pairs of bodies whose discs around them meet at the start, counted up to `most`: those that are tried at every step.
std::size_t close_pairs(const Scene& scene, const std::vector<BodyState>& states, std::size_t most) {
  struct Disc {
    double left, right;
    std::size_t body;
  };
  std::vector<Disc> discs;
  std::vector<double> radii;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    radii.push_back(bounding_radius(scene.bodies[i]));
    discs.push_back({states[i].position.x - radii[i], states[i].position.x + radii[i], i});
  }
  std::ranges::sort(discs, {}, &Disc::left);
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = i + 1; j < discs.size() && discs[j].left <= discs[i].right; ++j) {
      const std::size_t a = discs[i].body;
      const std::size_t b = discs[j].body;
      if (length(states[a].position - states[b].position) > radii[a] + radii[b]) continue;
      if (++pairs == most) return pairs;
    }
  }
  return pairs;
}

constexpr std::size_t many_pairs = 100'000;  // a second or so a step
constexpr std::size_t many_shapes = 3'000;

void warn_of_size(const Scene& scene, std::size_t pairs, std::vector<std::string>& all) {
  Warnings warnings(all);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].shapes.size() < many_shapes) continue;
    warnings.add(
        fmt::format("{}: has {} shapes: a run may take minutes", place_of(scene, i), scene.bodies[i].shapes.size()));
  }
  if (pairs == many_pairs) warnings.add("bodies: most start in one place: a run may take minutes");
}

void warn_of_overlaps(const Scene& scene, const std::vector<BodyState>& states, std::vector<std::string>& all) {
  constexpr double share = 0.01;  // of the smaller body; less may be meant, or rounding
  Warnings warnings(all);
  for (const BodyOverlap& one : Overlap(scene).all(states)) {
    const auto size = [&](std::size_t body) {
      const double radius = bounding_radius(scene.bodies[body]);
      return radius > 0 ? radius : HUGE_VAL;  // a half-space has none
    };
    if (one.depth <= share * std::min(size(one.a), size(one.b))) continue;
    warnings.add(
        fmt::format("{}: starts {:.3g} m inside {}", place_of(scene, one.b), one.depth, place_of(scene, one.a)));
  }
}

void warn_of_angles(const Scene& scene, std::vector<std::string>& all) {
  Warnings warnings(all);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const double angle = scene.bodies[i].angle;
    if (std::abs(angle) <= 2 * std::numbers::pi) continue;
    warnings.add(
        fmt::format("{}.angle: {:g} is more than a full turn; angles are in radians, and {:g} degrees are {:.6g}",
                    place_of(scene, i), angle, angle, angle * std::numbers::pi / 180));
  }
}

// Densities per volume, kg/m^3, begin there; a scene in metres and kilograms has about 1 kg/m^2.
void warn_of_densities(const Scene& scene, std::vector<std::string>& all) {
  constexpr double per_volume = 500;
  Warnings warnings(all);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    const auto heavy =
        std::ranges::find_if(body.shapes, [](const Shape& one) { return one.surface.density >= per_volume; });
    if (body.type != BodyType::dynamic || heavy == body.shapes.end()) continue;
    warnings.add(fmt::format("{}.shapes[{}].density: {:g} kg/m^2 is per area; 1000 is that of water per volume",
                             place_of(scene, i), heavy - body.shapes.begin(), heavy->surface.density));
  }
}

void warn_of_joints(const Scene& scene, std::vector<std::string>& all) {
  constexpr double share = 0.01;  // of the length
  Warnings warnings(all);
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    const JointFacts facts = facts_of(scene.joints[i]);
    if (facts.keeps != JointFacts::Keeps::rod) continue;
    const double apart = length(facts.anchor_b - facts.anchor_a);
    if (std::abs(apart - facts.length) <= share * facts.length) continue;
    warnings.add(
        fmt::format("joints[{}].length: is {:g} m, but the anchors start {:g} m apart", i, facts.length, apart));
  }
}

}  // namespace

std::vector<std::string> warnings_about(const Scene& scene) {
  std::vector<std::string> all;
  const std::vector<BodyState> states = initial_states(scene);
  const std::size_t pairs = close_pairs(scene, states, many_pairs);
  std::size_t shapes = 0;
  for (const Body& body : scene.bodies) shapes += body.shapes.size();
  warn_of_size(scene, pairs, all);
  if (pairs < many_pairs && shapes < many_shapes) warn_of_overlaps(scene, states, all);
  warn_of_angles(scene, all);
  warn_of_densities(scene, all);
  warn_of_joints(scene, all);
  return all;
}

}  // namespace plumb
