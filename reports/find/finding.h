#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "reports/find/complaint.h"
#include "reports/find/kind.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// A scene in which an engine is wrong, cut down.
struct Finding {
  std::string engine;  // the name of a suspect
  Complaint complaint;
  std::string from;  // the drawn scene, "heap/3"
  Posed posed = Posed::well;
  Scene scene;  // without name and about
  int drawn_bodies = 0;
  int runs = 0;  // that cutting it down took

  int moving_bodies() const;
  /// What two findings of the same fault have in common: the engine, the reason, and which kinds of bodies, pairs that
  /// may touch, joints and forces there are.
  std::string signature() const;
  /// From the content of the scene and the engine: "box2d-energy-1a2b3c4d".
  std::string name() const;
  /// Its scene file, with name, and in words what fails and where it comes from.
  std::string file(std::uint64_t seed) const;
};

nlohmann::ordered_json as_json(const Finding&);
/// Throws nlohmann::json::exception or std::invalid_argument for what as_json does not write.
Finding finding_of(const nlohmann::ordered_json&);

/// What `file` wrote about a scene, for running it again.
struct Origin {
  std::string engine;  // "" if the scene was not written by a search
  Posed posed = Posed::well;
};
Origin origin_of(const Scene&);

}  // namespace plumb
