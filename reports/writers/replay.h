#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "reports/writers/run_curves.h"
#include "scenarios/scene/scene.h"

/// The data of the page's replays: the bodies' outlines and each run's motion, quantised and packed.
namespace plumb {

/// What one run may take of a page that holds many.
struct ReplayLimits {
  std::size_t poses = 160 * 1024;     // characters; beyond this, moments are dropped
  std::size_t contacts = 160 * 1024;  // characters; beyond this, the run has no contacts
};

/// Positions are rounded to steps of this fraction of the area that the run covers. The error, half a step, is less
/// than half a pixel on a screen of 4096 pixels that shows a sixteenth of the area.
constexpr double position_share = 1.0 / 65536;

/// One object a case, in the report's order: {"scenario", "variant", "scene": packed text of `outlines_of`, "runs"}.
///
/// A run is {"engine", "method", "moments", "every", "between", "length", "angle", "impulse", "energy", "contacts",
/// "apart", "overlap", "poses", "touches"}. It holds the first moment, every `every`-th one after it, and the last;
/// with straight lines between them, no point of a body is more than `between` m from the recorded motion. `length`
/// (m), `angle` (rad), `impulse` (N s) and `energy` (J) are the rounding steps of the columns. `apart` {time, value} is
/// the largest distance (RMS, m) from the reference, `overlap` {time, value, a, b} the deepest overlap; null if there
/// is none. `poses` packs smooth columns: the times, in microseconds; for each body x and y of the centre of mass and
/// the angle; linear, rotational and potential energy. `touches` packs the contact points by place, a place being the
/// k-th point between two bodies: the number of places; for each the number of its stays; and for each stay the number
/// of moments between the end of the stay before it and its begin, its length in moments, then steady columns x, y and
/// the impulse on the second body, x and y. It is empty unless `contacts` is "kept"; the other values are "none" (none
/// were reported) and "too many".
nlohmann::ordered_json replays_of(std::span<const RunCurves>, const ReplayLimits& = {});

/// The drawing of a scene: {"outlines", "bodies", "joints"}. An outline is {"points": [[x, y] ...], "radius"}, the
/// convex hull of its points grown by a radius, or {"normal", "offset"}, a half-space. A body is {"name", "type",
/// "outlines": indices}, in a frame at its centre of mass. A joint is a line between two anchors of a joint or spring:
/// {"a", "b", "at_a", "at_b"}, in the bodies' frames; `a` is null for an anchor in the world.
nlohmann::ordered_json outlines_of(const Scene&);

/// By body, m: the largest distance of any of its points from the centre of mass; 0 for unbounded shapes and bodies
/// without shapes.
std::vector<double> radii_of(const Scene&);

}  // namespace plumb
