#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/scene.h"

/// Reported contacts: grouped by pair, their velocities, impulses and friction coefficients.
namespace plumb {

/// m/s, of the point of a body that is at `point` in the world.
Vec velocity_at(const BodyState&, Vec point);

/// m/s, the velocity of b relative to a at the contact.
Vec relative_velocity(const ContactState&, std::span<const BodyState>);

/// m/s, the same at the start of a step, at what touches at its end: a corner comes there with its body, and a round
/// body touches wherever its centre leads.
Vec velocity_before(const Scene&, const ContactState&, std::span<const BodyState> then, std::span<const BodyState> now);

/// N s, the impulse on b, normal and tangential.
Vec impulse_of(const ContactState&);

/// rad, by which a contact's normal may rotate in a step of dt s: its bodies rotate, and a round body rolls over a
/// corner or past another, V dt/r.
double normal_rotation(const Scene&, const ContactState&, std::span<const BodyState>, double dt);

/// The contacts of two bodies in one step. a < b in every point, whichever the engine called a.
struct PairContacts {
  std::vector<ContactState> points;                // at least one
  double normal_impulse = 0, tangent_impulse = 0;  // N s, sums; the tangent is the normal rotated by +90 degrees

  /// Whether it pushes, or overlaps by more than `slack`, m, so that it should.
  bool acts(double slack) const;
  /// The smallest separation, m.
  double separation() const;
};

/// Scene indices, the smaller first.
using BodyPair = std::pair<std::size_t, std::size_t>;
using ContactsByPair = std::map<BodyPair, PairContacts>;

ContactsByPair contacts_by_pair(std::span<const ContactState>);

/// "a - b", by the names in the scene.
std::string pair_name(const Scene&, std::size_t a, std::size_t b);

/// N s, the change of a contact's normal impulse since the step before: from the nearest contact of the same pair then,
/// or from zero if there was none.
double impulse_change(std::span<const ContactState> before, const ContactState& now);

/// The largest share of a step's error by which one more of the stated iterations would still change the result; 0 for
/// a method without.
double unsolved_share(const Stepping&);

/// N s, by contact: how much the normal impulse may differ from the one that bounded its friction, which may be that of
/// an earlier step or iteration. Zero for a second-order method without iterations.
std::vector<double> stale_impulse_error(std::span<const ContactState> before, std::span<const ContactState> now,
                                        const Stepping&);

/// Coefficients of restitution between two bodies: the smallest and the largest over all pairs of shapes.
struct RestitutionBounds {
  double smallest = 0, largest = 0;
};

RestitutionBounds restitution_between(const Scene&, std::size_t a, std::size_t b);

/// Friction coefficients between two bodies. A contact does not say which of their shapes touch: where surfaces differ,
/// `largest_static` is the largest over all pairs of shapes, `smallest_dynamic` the smallest. The scene must outlive
/// it.
class FrictionBounds {
 public:
  explicit FrictionBounds(const Scene& scene) : scene_(scene) {}
  double largest_static(std::size_t a, std::size_t b) const;
  double smallest_dynamic(std::size_t a, std::size_t b) const;

 private:
  const Scene& scene_;
};

}  // namespace plumb
