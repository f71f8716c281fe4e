#pragma once

#include <string>
#include <vector>

#include "scenarios/scene/scene.h"

namespace plumb {

/// What is allowed in a scene file but rarely meant, each with its place: "bodies[3]: starts 0.2 m inside bodies[0]".
/// Bodies that start in each other, angles above a full turn, densities per volume, rigid joints that start stretched,
/// and what takes minutes to run.
std::vector<std::string> warnings_about(const Scene&);

}  // namespace plumb
