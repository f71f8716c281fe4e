#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "bodies/body_set.h"
#include "bodies/force_field.h"
#include "bodies/integrator.h"
#include "contacts/contact.h"
#include "core/workers.h"
#include "impulse/settings.h"
#include "joints/joint_set.h"
#include "narrow_phase/margin.h"

namespace impulse::inline IMPULSE_PRECISION {

class RestingPiles;

/// The input and output of a solver in one step.
struct StepData {
  BodySet& bodies;
  std::vector<Contact>& contacts;
  std::vector<ActiveJoint>& joints;
  const ForceField& forces;
  Integrator& integrator;
  const Settings& settings;
  Workers& workers;
  std::uint64_t contact_changes = 0;  // see ContactSet::changes(); 0: unknown
  bool may_rest = false;  // no other part of the step needs the contacts: the solver may keep some to itself
};

/// A method that advances bodies and contacts by one step: integrates, solves, corrects. Writes to each contact point
/// the impulses for the next warm start and the totals of the step.
class Solver {
 public:
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  virtual ~Solver() = default;
  virtual void step(StepData& data) = 0;
  /// Writes its own errors over those of one integrator step of settings.dt.
  virtual void state(const Settings& settings, StatedErrors& errors) const = 0;
  /// The gap up to which it needs contacts; by default only touching shapes.
  virtual Margin margin(const Settings&) const { return {}; }
  /// Whether contacts of bodies that hardly moved keep their points (see ContactSet::find).
  virtual bool contact_persistence() const { return false; }
  /// The piles at rest whose contacts it keeps to itself; null if it never does.
  virtual RestingPiles* resting() { return nullptr; }
};

/// The default method, `accurate`. `lanes`: solves large islands with the kernels, otherwise one contact at a time.
std::unique_ptr<Solver> make_accurate(bool lanes);
constexpr const char* accurate_source =
    "soft contacts and relaxation after E. Catto, Soft Constraints (GDC 2011) and Solver2D (2024); velocity Verlet; "
    "time-of-impact events";

}  // namespace impulse::inline IMPULSE_PRECISION
