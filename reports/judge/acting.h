#pragma once

#include <span>
#include <vector>

#include "reports/judge/conserved.h"
#include "scenarios/scene/scene.h"

namespace plumb {

struct Push {
  Vec force;          // N at the centre of mass
  double torque = 0;  // N m about it
};

/// What gravity and the scene's forces do to its dynamic bodies: a second reading of the scene, apart from the one
/// that engines without such forces are fed by. Joints and contacts are not among them. The scene must outlive it.
class Acting {
 public:
  explicit Acting(const Scene&);

  /// By body, in Scene order; zero for what is not dynamic.
  std::vector<Push> on(std::span<const BodyState>) const;

  /// W, the power that reaches the scene from outside through its forces alone: what moves the centre of an attraction
  /// that is not pulled back. (A constant force has a potential: see potential.)
  double power(std::span<const BodyState>) const;

  /// J, of constant forces: -F.x - T angle.
  double potential(std::span<const BodyState>) const;

  std::span<const Mass> masses() const { return conserved_.masses(); }
  const Conserved& conserved() const { return conserved_; }

 private:
  Vec attracted(const Attraction&, std::size_t body, std::span<const BodyState>) const;

  const Scene& scene_;
  Conserved conserved_;
};

}  // namespace plumb
