#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scene/scene.h"

namespace plumb {

struct Load {
  Vec force;          // N at the centre of mass, world frame
  double torque = 0;  // N m about the centre of mass
};

/// What a scene's attractions, springs and constant forces do to its bodies. For engines that know no such forces:
/// their adapters ask before each step and hand the answer to the engine as an external force, constant over the step.
class Loads {
 public:
  explicit Loads(const Scene&);

  /// Whether anything but gravity acts.
  bool any() const { return !forces_.empty(); }

  /// The loads on all bodies, in Scene order, when these are their states. Valid until the next call.
  std::span<const Load> at(std::span<const BodyState>);

 private:
  void add(const Attraction&, std::span<const BodyState>);
  void add(const Spring&, std::span<const BodyState>);
  void add(const Constant&, std::span<const BodyState>);

  struct Carrier {
    double mass = 0;  // kg; 0: immovable
    Vec center;       // of mass, body frame
  };
  std::vector<Force> forces_;
  std::vector<Carrier> bodies_;
  std::vector<Load> loads_;
};

}  // namespace plumb
