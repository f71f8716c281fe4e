#pragma once

#include <memory>

#include "reports/judge/metric.h"
#include "reports/judge/truth.h"
#include "reports/report.h"
#include "reports/run/run.h"

namespace plumb {

/// What is known of the right answer to a case; nothing of it, where there is none.
struct Known {
  const Truth* truth = nullptr;
  std::shared_ptr<const Trace> trace = nullptr;  // of the truth, with the steps of those it is held against

  MetricContext context(const Scene&, const Trace&) const;
};

/// What a run says, before it is measured: who, what, how it ended.
RunRecord record_of(const Case&, const EngineConfig&, double dt, const Outcome&);

/// The same, measured and judged against what is known, over several phases where the scenario asks for them. `asked`
/// may start next to the case that is known: then what must come true is still that case's.
RunRecord examine(const Case& asked, const EngineConfig&, double dt, const Outcome&, const Known&);

}  // namespace plumb
