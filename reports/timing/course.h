#pragma once

#include <span>
#include <vector>

#include "reports/judge/overlap.h"
#include "reports/judge/states.h"
#include "reports/report.h"

namespace plumb {

/// What a page shows of a run besides its states, by recorded moment.
struct Course {
  const RunRecord* run = nullptr;     // has a scene and a trace with a moment at least
  std::vector<PoseDifference> apart;  // from the closed form of its case, else from the first engine; may end early
  std::vector<BodyOverlap> deepest;   // overlaps, by the scene's geometry
};

/// Of every run that left something to see. The report must outlive them.
std::vector<Course> courses_of(const Report&);

}  // namespace plumb
