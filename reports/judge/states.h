#pragma once

#include <optional>
#include <span>
#include <vector>

#include "reports/trace.h"
#include "scenarios/scene/scene.h"

/// Measures of the states of a scene's bodies: at rest, and different from other states.
namespace plumb {

// Below these speeds a body looks still: it takes a second to move a centimetre.
inline constexpr double still_speed = 0.01;  // m/s
inline constexpr double still_spin = 0.01;   // rad/s

bool is_still(const BodyState&);

/// The number of dynamic bodies that are still.
double still_bodies(const Scene&, std::span<const BodyState>);

bool has_something_to_rest_on(const Scene&);

/// s, the time from which all dynamic bodies are still until the end; nullopt if one still moves at the end, or nothing
/// fixed is there to rest on.
std::optional<double> time_to_rest(const Scene&, const Trace&);

/// m/s, the speed of the fastest dynamic body; 0 if there is none.
double fastest_speed(const Scene&, std::span<const BodyState>);

/// The difference between two runs of a scene at a moment: RMS over the dynamic bodies.
struct PoseDifference {
  double position = 0;  // m
  double angle = 0;     // rad
};

PoseDifference pose_difference(const Scene&, std::span<const BodyState> a, std::span<const BodyState> b);

/// The difference at every moment of `a` up to `until`, s, and to b's end; b is interpolated between its moments.
std::vector<PoseDifference> pose_differences(const Scene&, const Trace& a, const Trace& b, double until);

}  // namespace plumb
