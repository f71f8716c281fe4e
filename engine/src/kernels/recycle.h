#pragma once

#include <cstdint>

#include "contact.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A contact's points on bodies that have moved since they were found.
struct PointsAgain {
  Real separation[2];  // m
  Real motion;         // m, no point of the two bodies has come farther, added up
  Real unused;         // four lanes
};

/// Measures contacts[items[i]] again into again[i], for i below count.
using MeasureAgain = void(const Contact* contacts, const std::uint32_t* items, std::uint32_t count, const Pose* poses,
                          const Real* reach, PointsAgain* again);

}  // namespace impulse::inline IMPULSE_PRECISION
