#pragma once

#include <string>
#include <vector>

#include "reports/compare/divergence.h"
#include "reports/compare/same_enough.h"

namespace plumb {

/// What the contacts of a step tell of why two runs part in it.
struct PartingContact {
  Stage stage = Stage::integration;
  std::string other;  // whom the body touches there; "" where no contact is to blame
  std::vector<Figure> figures;
  std::string advice;
};

/// Looks at what touches the body in that step (from 1), directly or by way of other bodies, in the order in which a
/// step is done: who is touched, where, and how hard. States before the step are the same; `allowed` is for the step.
PartingContact parting_contact(const Scene&, const Side& a, const Side& b, std::size_t step, std::size_t body,
                               const SameEnough& allowed);

}  // namespace plumb
