#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reports/study/results_file.h"
#include "reports/study/study.h"
#include "reports/writers/output.h"

namespace plumb {

/// A whole study: its points in the plan's order and what they come to. Everything that hangs on the clock is under
/// "timings"; the rest is the same in every run, however it was cut up.
nlohmann::ordered_json document_of(const Study&, const ResultsHead&, const std::vector<PointResult>&, const Findings&);

/// A line a point; values and times become columns, as far as they are numbers, words or yes and no.
std::string csv_of(const std::vector<PointResult>&);

/// Concludes, writes study-NAME.json, .csv and .html into the folder, and tells of it on the console. The results are
/// those of every point of the plan, in its order.
void write_study(const Study&, const ResultsHead&, const StudyPlan&, const std::vector<PointResult>&,
                 const OutputFolder&);

}  // namespace plumb
