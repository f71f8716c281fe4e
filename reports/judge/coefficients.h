#pragma once

#include <cstddef>

#include "scenarios/scene/scene.h"

namespace plumb {

/// The coefficients of friction between two bodies. A contact does not tell which of their shapes met: where surfaces
/// differ, `sticking` is the largest of any two, `sliding` the smallest. The scene must outlive it.
class Coefficients {
 public:
  explicit Coefficients(const Scene& scene) : scene_(scene) {}
  double sticking(std::size_t a, std::size_t b) const;
  double sliding(std::size_t a, std::size_t b) const;

 private:
  const Scene& scene_;
};

}  // namespace plumb
