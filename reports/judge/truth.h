#pragma once

#include <optional>
#include <vector>

#include "reference/simulation.h"

namespace plumb {

/// What physics says of one scene, by its closed form. The scene must outlive it.
class Truth {
 public:
  /// `closed_form` must support the scene.
  Truth(const Engine& closed_form, const Scene&);

  /// The states at a time, s, evaluated there (a closed form needs no small steps); nothing beyond its validity.
  std::optional<std::vector<BodyState>> at(double time) const;

  /// Seconds for which it holds.
  double until() const { return until_; }

 private:
  const Engine& closed_form_;
  const Scene& scene_;
  double until_;
};

}  // namespace plumb
