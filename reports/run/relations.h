#pragma once

#include <string>
#include <vector>

#include "reports/judge/relation.h"
#include "reports/run/run.h"

/// Runs the images of a scene and checks the metamorphic relations.
namespace plumb {

/// All relations, or only those named, by name: one check each, also of those that say nothing here (see
/// `RelationCheck::why_not`). `trace` is the config's own run of the scene with steps of dt, to its end. An image that
/// the engine cannot run is none; one whose run fails breaks the relation. What a scene makes of differences is
/// measured only where it is needed.
std::vector<RelationCheck> check_relations(const Scene&, const EngineConfig&, double dt, const Trace& trace,
                                           const std::vector<std::string>& only = {});

/// The images of one relation, to be shown beside the scene.
std::vector<Image> images_of(const std::string& relation, const Scene&, const Trace& trace, double dt);

}  // namespace plumb
