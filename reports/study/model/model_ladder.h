#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/run/run.h"

/// What a model of our engine is made of, feature by feature.
namespace plumb {

/// Less of a feature.
struct ModelRung {
  std::string without;  // in words
  Settings change;
};

/// Something that a scene may need, and ways to do with less of it, or without.
struct Feature {
  std::string name;
  std::vector<ModelRung> rungs;
};

const std::vector<Feature>& model_features();

/// For each feature, on which rung it is; 0: not dropped.
using Levels = std::vector<std::size_t>;

/// The model without what these drop; `full` has all of it.
EngineConfig model_at(const EngineConfig& full, const Levels&);

/// All that is on a rung, by itself: every single drop that changes the full model.
struct Drop {
  std::size_t feature = 0;
  std::size_t rung = 0;
  std::string setting;  // "key=value,..."
};
std::vector<Drop> single_drops(const EngineConfig& full);

}  // namespace plumb
