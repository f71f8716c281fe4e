#pragma once

#include <span>
#include <vector>

#include "reference/simulation.h"
#include "reports/find/complaint.h"
#include "reports/find/finding.h"
#include "reports/find/judge.h"

namespace plumb {

/// The most that one run may take, with what judges it. Orders of magnitude more than a scene of a search needs.
struct RunLimits {
  double seconds = 10;  // of a processor: a busy machine changes no finding
  double mebibytes = 2048;
};

/// Judges suspects, each in a process of its own: one that crashes, hangs or takes too much memory gets a complaint of
/// the judge "run". What a suspect's right engine fails as well is left out. Where finding out what is known of the
/// scene crashes or takes too long, only laws judge, and the opinions say so. Only a process without other threads may
/// call it, as the following.
std::vector<Opinion> judged_apart(const Scene&, Posed, std::span<const Suspect>, const Judges&, const RunLimits&);

/// The states that a suspect's run reaches at a time, s; empty if it does not get there within the limits.
std::vector<BodyState> states_apart(const Scene&, const Suspect&, double time, const RunLimits&);

/// See run_to_show; nothing of it if that takes more than the limits, or crashes.
FailingRun shown_apart(const Scene&, const Complaint&, const Suspect&, std::span<const Suspect> others,
                       const RunLimits&);

}  // namespace plumb
