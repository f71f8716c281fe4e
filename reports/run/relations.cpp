#include "reports/run/relations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "reference/scene_facts.h"
#include "reports/judge/overlap.h"
#include "reports/run/catalog_case.h"
#include "reports/run/horizon.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

// An engine may decide otherwise for one half of all displacements, or for those of one size: round-off is smaller than
// its bound by about the square root of the number of roundings, and up to that number.
constexpr double tied_sizes[] = {1, 1.0 / 32, 1.0 / 1024};  // of the bound
constexpr int tied_runs = 2;                                // of each

class MeasuredAmplification : public Amplification {
 public:
  MeasuredAmplification(const SceneGrowth& scene, const EngineConfig& config, double dt, const Trace& trace)
      : scene_(scene),
        config_(config),
        dt_(dt),
        trace_(trace),
        limit_(divergence_distance(scene.scene())),
        directions_(directions_of(scene.scene())) {}

  std::optional<double> of(double size, std::size_t moment, std::size_t body) const override {
    const Growth& growth = scene_.growth();
    if (moment >= growth.moments()) return std::nullopt;
    const auto found = growth.factor(size, moment, body);
    if (!found) return std::nullopt;
    const double factor = std::max(found->per_metre.place, rim_of(body) * found->per_metre.angle);
    // Displacements that have diverged have stopped growing: their factor says nothing of smaller ones.
    if (factor * found->tried > limit_ && found->per_metre.place > diverging) return std::nullopt;
    return directions_ * factor * size;
  }

  std::optional<double> of_method(const Stepping& stepping, std::size_t moment, std::size_t body) const override {
    const Growth& growth = scene_.growth();
    if (moment >= growth.moments()) return std::nullopt;
    // An engine with a skin may touch a step before the one that growth is measured with, which may be a step late.
    const std::size_t touched = std::min(moment + 2, growth.moments() - 1);
    const auto shift = growth.allowance(stepping, touched, body);
    if (!shift) return std::nullopt;
    return std::max(shift->place, rim_of(body) * shift->angle);
  }

  double undecided_from(double size, std::span<const double> rounding) const override {
    double from = std::numeric_limits<double>::infinity();
    std::uint64_t seed = 0;
    for (const double share : tied_sizes) {
      for (int i = 0; i < tied_runs; ++i) from = std::min(from, decided_in(++seed, share * size, rounding));
    }
    return from;
  }

 private:
  static constexpr double diverging = 100;  // a larger growth is more than a few impacts make

  // Growth is that of random displacements, the root mean square s of sums of what each coordinate's alone does. Of all
  // that are as large, one along the signs of these does up to sqrt(n) s, of n coordinates (Cauchy and Schwarz).
  static double directions_of(const Scene& scene) {
    const auto moves = [](const Body& body) { return body.type == BodyType::dynamic; };
    return std::sqrt(3. * static_cast<double>(std::count_if(scene.bodies.begin(), scene.bodies.end(), moves)));
  }

  double rim_of(std::size_t body) const {
    const double radius = bounding_radius(scene_.scene().bodies[body]);
    return radius > 0 ? radius : smallest_body(scene_.scene());
  }

  // s, when a run from a start displaced by up to `size`, m, is farther from ours than that and rounding explain, or a
  // step before: what it decides in one step, another run may decide in the step before.
  double decided_in(std::uint64_t seed, double size, std::span<const double> rounding) const {
    const Outcome other = run(displaced(scene_.scene(), size, seed), config_, dt_);
    const std::size_t both = other.trace ? std::min(rounding.size(), other.trace->size()) : 0;
    for (std::size_t moment = 0; moment < both; ++moment) {
      // Displaced along both axes and turned.
      if (!explained(3 * size + rounding[moment], moment, other.trace->states(moment))) {
        return trace_.time(moment > 0 ? moment - 1 : 0);
      }
    }
    return std::numeric_limits<double>::infinity();
  }

  bool explained(double size, std::size_t moment, std::span<const BodyState> states) const {
    const Scene& scene = scene_.scene();
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      if (scene.bodies[i].type != BodyType::dynamic) continue;
      const auto most = of(size, moment, i);
      if (!most) return true;
      const BodyState& here = trace_.states(moment)[i];
      if (length(here.position - states[i].position) > *most) return false;
      if (rim_of(i) * std::abs(here.angle - states[i].angle) > *most) return false;
    }
    return true;
  }

  const SceneGrowth& scene_;
  const EngineConfig& config_;
  double dt_;
  const Trace& trace_;
  double limit_;       // m
  double directions_;  // what the worst displacement does, of what a random one does
};

// The run of an image, with all that a relation looks at.
struct ImageRun {
  ImageRun(const Image& image, const EngineConfig& config)
      : growth(image.scene, image.dt), outcome(run(image.scene, config, image.dt)) {
    if (outcome.status != Status::ok) return;
    stepping = config.engine->stepping(config.settings, image.dt);
    amplification.emplace(growth, config, image.dt, *outcome.trace);
  }

  SceneGrowth growth;
  Outcome outcome;
  Stepping stepping;
  std::optional<MeasuredAmplification> amplification;
};

RelationCheck check_relation(const MetamorphicRelation& relation, const RelationRun& original,
                             const EngineConfig& config, double dt) {
  RelationCheck result;
  result.why_not = relation.excludes(original.scene, original.stepping);
  if (!result.why_not.empty()) return result;
  const std::vector<Image> images = relation.images(original.scene, original.trace, dt);
  std::vector<std::unique_ptr<ImageRun>> runs;
  std::vector<RelationRun> judged;
  for (const Image& image : images) {
    const ImageRun& one = *runs.emplace_back(std::make_unique<ImageRun>(image, config));
    if (one.outcome.status == Status::not_supported) {
      result.why_not = "the engine cannot run the image: " + one.outcome.reason;
      return result;
    }
    if (one.outcome.status == Status::failed) {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      result.check = {.status = CheckStatus::broken,
                      .value = infinity,
                      .ratio = infinity,
                      .time = one.outcome.time,
                      .detail = "the run of the image failed: " + one.outcome.reason};
      result.share = infinity;
      return result;
    }
    judged.push_back({image.scene, *one.outcome.trace, one.stepping, *one.amplification});
  }
  return relation.compare(original, judged);
}

const MetamorphicRelation& find_relation(const std::string& name) {
  return find_entry<MetamorphicRelation>("relation", name);
}

}  // namespace

const Growth& SceneGrowth::growth() const {
  if (!growth_) growth_.emplace(scene_, dt_, scene_.duration);
  return *growth_;
}

std::vector<RelationCheck> check_relations(const SceneGrowth& growth, const EngineConfig& config, double dt,
                                           const Trace& trace, const std::vector<std::string>& only) {
  for (const std::string& name : only) find_relation(name);
  std::vector<RelationCheck> checks;
  if (trace.size() < 2) return checks;
  const MeasuredAmplification amplification(growth, config, dt, trace);
  const Stepping stepping = config.engine->stepping(config.settings, dt);
  const RelationRun original{growth.scene(), trace, stepping, amplification};
  for (const MetamorphicRelation* relation : Catalog<MetamorphicRelation>::all()) {
    if (!only.empty() && std::find(only.begin(), only.end(), relation->name) == only.end()) continue;
    RelationCheck check = check_relation(*relation, original, config, dt);
    check.name = relation->name;
    check.check.name = relation->name;
    check.check.unit = relation->unit;
    checks.push_back(std::move(check));
  }
  return checks;
}

std::vector<RelationCheck> check_relations(const Scene& scene, const EngineConfig& config, double dt,
                                           const Trace& trace, const std::vector<std::string>& only) {
  return check_relations(SceneGrowth(scene, dt), config, dt, trace, only);
}

std::vector<Image> images_of(const std::string& relation, const Scene& scene, const Trace& trace, double dt) {
  return find_relation(relation).images(scene, trace, dt);
}

}  // namespace plumb
