#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/judge/relation.h"
#include "reports/run/horizon.h"
#include "reports/run/run.h"

/// Runs the images of a scene and checks the metamorphic relations.
namespace plumb {

/// What a scene makes of differences, measured when it is first asked for. The scene must outlive it.
class SceneGrowth {
 public:
  SceneGrowth(const Scene& scene, double dt) : scene_(scene), dt_(dt) {}

  const Scene& scene() const { return scene_; }
  const Growth& growth() const;

 private:
  const Scene& scene_;
  double dt_;
  mutable std::optional<Growth> growth_;
};

/// All relations, or only those named, by name: one check each, also of those that say nothing here (see
/// `RelationCheck::why_not`). `trace` is the config's own run of the scene with steps of dt, to its end. An image that
/// the engine cannot run says nothing; one whose run fails breaks the relation.
std::vector<RelationCheck> check_relations(const Scene&, const EngineConfig&, double dt, const Trace& trace,
                                           const std::vector<std::string>& only = {});

/// The same for several engines of one scene, which is measured once.
std::vector<RelationCheck> check_relations(const SceneGrowth&, const EngineConfig&, double dt, const Trace& trace,
                                           const std::vector<std::string>& only = {});

/// The images of one relation, to be shown beside the scene.
std::vector<Image> images_of(const std::string& relation, const Scene&, const Trace& trace, double dt);

}  // namespace plumb
