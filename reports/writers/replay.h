#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "reports/timing/course.h"

/// What the page replays: the bodies' outlines, and what each run did with them, quantised and packed.
namespace plumb {

/// A page holds many runs; what one of them may take of it.
struct ReplayLimits {
  std::size_t poses = 320 * 1024;     // characters: beyond, moments are left out
  std::size_t contacts = 160 * 1024;  // the same: beyond, no contacts are kept
};

/// Positions are in steps of this share of what the run covers: the rounding, half of it, is less than half a pixel on
/// a screen that shows a sixteenth of that on 4096 pixels.
constexpr double position_share = 1.0 / 65536;

/// One object a case, in the report's order: {"scenario", "variant", "scene": packed text of `outlines_of`, "runs"}.
///
/// A run is {"engine", "method", "moments", "every", "between", "length", "angle", "impulse", "energy", "contacts",
/// "apart", "overlap", "poses", "touches"}. Kept are the first moment, each `every`-th after it and the last; drawn
/// straight between them, no point of a body is more than `between` m off what the run recorded. `length` (m), `angle`
/// (rad), `impulse` (N s) and `energy` (J) are the steps of the rounded columns. `apart` {time, value} is where the run
/// is furthest (RMS, m) from what it is measured by, `overlap` {time, value, a, b} its deepest overlap; null where
/// there is none. `poses` packs smooth columns: the times, in microseconds; of each body in turn x and y of the centre
/// of mass and the angle; linear, rotational and potential energy. `touches` packs the contact points by place, a place
/// being the k-th point between two bodies: how many places; of each the number of its stays, and of each stay how many
/// moments after the end of the one before it begins, how many it lasts, then steady columns x, y and the impulse on
/// the second body, x and y. Empty where `contacts` is not "kept": "none" were shown, or they are "too many".
nlohmann::ordered_json replays_of(std::span<const Course>, const ReplayLimits& = {});

}  // namespace plumb
