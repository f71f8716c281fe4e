#pragma once

#include <cstdint>
#include <vector>

#include "bodies/body_set.h"
#include "bodies/force_field.h"
#include "bodies/integrator.h"
#include "contacts/contact.h"
#include "core/workers.h"
#include "impulse/settings.h"
#include "joints/joint_set.h"

namespace impulse::inline IMPULSE_PRECISION {

class RestingPiles;

/// All that a solver works on during one step.
struct StepData {
  BodySet& bodies;
  std::vector<Contact>& contacts;
  std::vector<ActiveJoint>& joints;
  const ForceField& forces;
  Integrator& integrator;
  const Settings& settings;
  Workers& workers;
  std::uint64_t contact_changes = 0;  // see ContactSet::changes(); 0: nobody knows
  bool may_rest = false;              // nobody but the solver and who reads them asks for contacts
};

/// How far apart two shapes may be and still make a contact ("speculative" contacts, which let a solver see what it is
/// about to hit).
struct Margin {
  Real distance = 0;  // m
  Real time = 0;      // s; adds the distance that the two may close in this time at their present velocities
};

/// One method of carrying bodies and contacts over a step: integrates, solves, corrects. Leaves in each contact point
/// the impulses for the next warm start and the totals of the step.
class Solver {
 public:
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  virtual ~Solver() = default;
  virtual void step(StepData& data) = 0;
  /// Its own errors, laid over those of one integrator step of settings.dt.
  virtual void state(const Settings& settings, StatedErrors& errors) const = 0;
  /// The contacts that it wants to be given; only touching shapes unless it says otherwise.
  virtual Margin margin(const Settings&) const { return {}; }
  /// Whether points of bodies that hardly moved stay where they are (see contact_set.h).
  virtual bool recycles() const { return false; }
  /// The piles whose contacts it keeps to itself, if it keeps some.
  virtual RestingPiles* resting() { return nullptr; }
};

}  // namespace impulse::inline IMPULSE_PRECISION
