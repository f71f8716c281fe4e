#pragma once

#include <vector>

#include "body_set.h"
#include "impulse/force.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Adds what a generator does to every body: v in m/s^2, w in rad/s^2.
void accelerate(const Attraction&, const BodySet&, std::vector<Velocity>& out);
void accelerate(const Spring&, const BodySet&, std::vector<Velocity>& out);
void accelerate(const ConstantForce&, const BodySet&, std::vector<Velocity>& out);

/// Throws std::invalid_argument for numbers that make no sense, std::out_of_range for bodies that are not there.
void check(const Attraction&, const BodySet&);
void check(const Spring&, const BodySet&);
void check(const ConstantForce&, const BodySet&);

bool names(const Attraction&, BodyId);
bool names(const Spring&, BodyId);
bool names(const ConstantForce&, BodyId);

}  // namespace impulse::inline IMPULSE_PRECISION
