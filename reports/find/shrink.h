#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/find/complaint.h"
#include "scenarios/scene/scene.h"

/// Makes a scene that fails smaller and simpler as long as it fails for the same reason (delta debugging: A. Zeller and
/// R. Hildebrandt, Simplifying and Isolating Failure-Inducing Input, 2002).
namespace plumb {

/// One way to make a scene simpler. Joins Catalog<Cut> from its own file in reports/find/cuts/.
struct Cut {
  std::string name;
  int order = 0;  // small: tried first, as it removes most
  /// Scenes that are simpler in one respect each, the boldest first; `at` is what the scene fails by.
  std::function<std::vector<Scene>(const Scene&, const Complaint& at)> simpler;
};

/// Runs a scene and returns by what it fails for the reason that is looked for; nullopt if it does not.
using Failing = std::function<std::optional<Complaint>(const Scene&)>;

struct Shrunk {
  Scene scene;
  Complaint complaint;
  int runs = 0;
};

/// The smallest scene that at most `budget` runs find. It never starts with bodies deeper in each other, or with joints
/// moving further apart, than the given one, and stays clearly wrong: off by twice what is allowed if it was.
Shrunk shrink(const Scene&, const Complaint&, const Failing&, int budget);

}  // namespace plumb
