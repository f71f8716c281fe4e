#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "reports/run/run.h"

/// The features of our engine's full model, and the search for the cheapest model that is still accurate enough.
namespace plumb {

struct JobOutput;
class ModelError;

/// One way to have less of a feature.
struct FeatureStep {
  std::string without;  // what is dropped, in words
  Settings change;
};

/// Something that a scene may need, and steps to less of it, down to none.
struct Feature {
  std::string name;
  std::vector<FeatureStep> steps;
};

const std::vector<Feature>& model_features();

/// For each feature, the step that is taken, counted from 1; 0 keeps the whole feature.
using FeatureLevels = std::vector<std::size_t>;

/// The full model with these steps taken.
EngineConfig model_at(const EngineConfig& full, const FeatureLevels&);

/// One step of one feature.
struct FeatureDrop {
  std::size_t feature = 0;
  std::size_t step = 0;
  std::string setting;  // "key=value,..."
};

/// Every drop that by itself changes the full model.
std::vector<FeatureDrop> single_drops(const EngineConfig& full);

/// The full model with `model=auto`: the engine itself chooses what to leave out of a scene.
EngineConfig automatic_model(const EngineConfig& full);

/// What the search learns by trying models.
struct ModelTrials {
  std::function<bool(const FeatureLevels&)> sufficient;
  std::function<double(const FeatureLevels& a, const FeatureLevels& b)> cost_ratio;  // of a to b, estimated
  /// Whether a is cheaper than b, by more than noise and by enough to matter.
  std::function<bool(const FeatureLevels& a, const FeatureLevels& b)> cheaper;
  /// Whether `sufficient` takes longer than `cost_ratio`: then drops that save nothing are not tried.
  bool slow_to_judge = false;
  /// Whether the search must end; what it has found until then stands.
  std::function<bool()> out_of_time = [] { return false; };
};

/// The cheapest sufficient model that dropping features one after another leads to. The drops that save most by
/// themselves come first; at the end, redundant drops, which save nothing any more, are undone. Returns the full model
/// if no drop is sufficient.
FeatureLevels least_model(const std::vector<FeatureDrop>&, std::size_t features, const ModelTrials&);

/// Searches the least model of a case by measuring models. Everything found depends on the clock, because costs do. The
/// full model must have been run (ModelError::find).
/// The search ends in time to return what it has found within `seconds`; "complete" says whether it came to its end.
JobOutput search_least_model(const ModelError&, double seconds);

}  // namespace plumb
