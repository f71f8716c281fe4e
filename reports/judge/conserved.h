#pragma once

#include <span>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/scene.h"

namespace plumb {

struct Energy {
  double linear = 0;      // J, sum of m v^2/2
  double rotational = 0;  // J, sum of I w^2/2
  double potential = 0;   // J, gravity's -m s g.r (s the gravity scale), springs' and attractions'
  double kinetic() const { return linear + rotational; }
  double total() const { return linear + rotational + potential; }
};

struct Momentum {
  Vec linear;          // kg m/s
  double angular = 0;  // kg m^2/s, about the world's origin
};

/// Energy and momentum of a scene's dynamic bodies, from the scene and their states alone: no engine is asked. The
/// scene must outlive it.
class Conserved {
 public:
  explicit Conserved(const Scene&);

  Energy energy(std::span<const BodyState>) const;
  Momentum momentum(std::span<const BodyState>) const;

  /// By body, in Scene order.
  std::span<const Mass> masses() const { return masses_; }

 private:
  double potential_of(const Attraction&, std::span<const BodyState>) const;

  // An elastic tie between two points: of a body's frame about its centre of mass, or of the world.
  struct Tie {
    std::optional<std::size_t> a;
    std::size_t b = 0;
    Vec at_a, at_b;
    double stiffness = 0, length = 0;
  };

  const Scene& scene_;
  std::vector<Mass> masses_;
  std::vector<Tie> ties_;
};

/// The states that the scene asks everyone to start from.
std::vector<BodyState> initial_states(const Scene&);

}  // namespace plumb
