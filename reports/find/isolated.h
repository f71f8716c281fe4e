#pragma once

#include "reports/find/complaint.h"
#include "reports/find/judge.h"
#include "reports/find/suspect.h"

namespace plumb {

/// The most that one run may take, with what judges it. Orders of magnitude more than a scene of a search needs.
struct RunLimits {
  double seconds = 10;
  double mebibytes = 2048;
};

/// Judges a suspect in a process of its own: one that crashes, hangs or takes too much memory gets a complaint of the
/// judge "run". What the suspect's right engine fails as well is left out. Only a process without other threads may
/// call it.
Opinion judged_apart(const Scene&, Posed, const Suspect&, const Known&, const RunLimits&);

}  // namespace plumb
