#pragma once

#include <cstdint>
#include <vector>

#include "bodies/body_set.h"
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

/// The rows of the bodies whose motion it makes depend on each other: of all others on the first's.
void append_bodies(const Attraction&, const BodySet&, std::vector<std::uint32_t>& out);
void append_bodies(const Spring&, const BodySet&, std::vector<std::uint32_t>& out);
void append_bodies(const ConstantForce&, const BodySet&, std::vector<std::uint32_t>& out);

bool names(const Attraction&, BodyId);
bool names(const Spring&, BodyId);
bool names(const ConstantForce&, BodyId);

}  // namespace impulse::inline IMPULSE_PRECISION
