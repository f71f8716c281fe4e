#pragma once

#include <span>
#include <vector>

#include "reference/simulation.h"

namespace plumb {

/// Reads a simulation and checks that its adapter fills the results correctly. The returned spans are valid until the
/// next read.
class Readout {
 public:
  explicit Readout(const Scene& scene) : scene_(scene) {}

  /// One per body. Throws std::runtime_error if `read` leaves a body out or writes past the last one.
  std::span<const BodyState> states(const Simulation&);

  /// Throws std::runtime_error for a contact of bodies that are not in the scene, or one that is not finite.
  std::span<const ContactState> contacts(const Simulation&);

 private:
  const Scene& scene_;
  std::vector<BodyState> states_;
  std::vector<ContactState> contacts_;
};

}  // namespace plumb
