#pragma once

#include <vector>

#include "body_set.h"
#include "contact.h"
#include "force_field.h"
#include "impulse/settings.h"
#include "integrator.h"

namespace impulse::inline IMPULSE_PRECISION {

/// All that a solver works on during one step.
struct StepData {
  BodySet& bodies;
  std::vector<Contact>& contacts;
  const ForceField& forces;
  Integrator& integrator;
  const Settings& settings;
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
};

}  // namespace impulse::inline IMPULSE_PRECISION
