#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "reports/find/draw.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {

/// A kind of random scenes. Joins Catalog<Kind> from its own file in reports/find/kinds/.
struct Kind {
  std::string name;
  std::string about;  // one line
  Posed posed = Posed::well;
  std::function<Scene(Draw&)> scene;  // its name and about are filled in by `drawn`
};

/// The n-th scene of a kind, n from 0, named "KIND/n": the same on every machine and whatever else is drawn.
Scene drawn(const Kind&, std::uint64_t seed, int n);

}  // namespace plumb
