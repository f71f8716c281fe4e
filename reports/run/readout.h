#pragma once

#include <span>
#include <vector>

#include "reference/simulation.h"

namespace plumb {

/// Reads a simulation, and tells an adapter that does not do as it should what it did. What is handed out holds until
/// the next reading.
class Readout {
 public:
  explicit Readout(const Scene& scene) : scene_(scene) {}

  /// One per body. Throws std::runtime_error where `read` leaves a body out or writes past the last one.
  std::span<const BodyState> states(const Simulation&);

  /// Throws std::runtime_error for a contact of bodies that are not in the scene, or one that is not finite.
  std::span<const ContactState> contacts(const Simulation&);

 private:
  const Scene& scene_;
  std::vector<BodyState> states_;
  std::vector<ContactState> contacts_;
};

}  // namespace plumb
