#pragma once

#include <span>
#include <vector>

#include "reports/find/complaint.h"
#include "reports/find/judge.h"
#include "reports/find/suspect.h"

namespace plumb {

/// The most that one run may take, with what judges it. Orders of magnitude more than a scene of a search needs.
struct RunLimits {
  double seconds = 10;
  double mebibytes = 2048;
};

/// Judges suspects, each in a process of its own: one that crashes, hangs or takes too much memory gets a complaint of
/// the judge "run". What a suspect's right engine fails as well is left out. Where finding out what is known of the
/// scene crashes or takes too long, only laws judge. Only a process without other threads may call it.
std::vector<Opinion> judged_apart(const Scene&, Posed, std::span<const Suspect>, const Judges&, const RunLimits&);

}  // namespace plumb
