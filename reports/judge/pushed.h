#pragma once

#include <span>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scenario.h"

namespace plumb {

/// N s, by how much more or less a contact pushes than a step before: than the nearest of its pair's contacts then, or
/// nothing.
double changed(std::span<const ContactState> before, const ContactState& now);

/// N s, by how much the push of a contact may differ from the one that friction was held to, which is that of an
/// earlier step or sweep; by contact. Nothing for a method of second order.
std::vector<double> known_late(std::span<const ContactState> before, std::span<const ContactState> now,
                               const Stepping&);

}  // namespace plumb
