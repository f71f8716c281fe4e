#pragma once

#include <optional>
#include <vector>

#include "reports/judge/overlap.h"

/// Where on an outline another one may touch it.
namespace plumb {

/// A convex set that holds every point of the core of `of` within `reach`, m, of the core of `other`: `of` cut by the
/// tangents of `other`, moved out by `reach`. (The core of an outline is what it grows by its radius.) Empty if there
/// is none. Neither may be a half-space, except `other`.
std::vector<Vec> region_near(const Outline& of, const Outline& other, double reach);

/// The unit vector from the core of one to the nearest point of the core of the other; nullopt if the cores meet.
std::optional<Vec> direction_to(const Outline& from, const Outline& to);

/// Whether a convex region of a core has none of its corners, so that every contact there has the same normal.
bool is_flat_in(const Outline&, const std::vector<Vec>& region);

}  // namespace plumb
