#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "reports/find/draw.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// What rigid-body mechanics says of a kind's scenes, which decides by what they may be judged.
enum class Posed {
  well,        // one motion follows from the start: everything may judge
  ambiguous,   // several motions are right, as after impacts at the same moment: laws judge, places and images don't
  impossible,  // rigidity and Coulomb's friction contradict each other: only energy and finite numbers judge
  overlapping  // bodies start in each other, which rigid ones cannot: a run must end, with finite numbers
};

/// "well", "ambiguous", "impossible", "overlapping".
const char* name_of(Posed);

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
