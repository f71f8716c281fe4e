#pragma once

#include <filesystem>
#include <vector>

#include "reports/study/document.h"

namespace plumb {

struct Merged {
  const Study* study = nullptr;
  ResultsHead head;  // of the whole
  StudyPlan plan;
  std::vector<PointResult> results;  // in the plan's order
};

/// What the unsharded study would have found out, from the results files of all its shards. Throws
/// std::invalid_argument, with all that is wrong, by name: a shard that is there twice, one that is missing or not
/// complete, one of another study, configuration or version, points that are no business of its shard.
Merged merge(const std::vector<std::filesystem::path>& files);

}  // namespace plumb
