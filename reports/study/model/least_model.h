#pragma once

#include <functional>
#include <vector>

#include "reports/study/model/model_ladder.h"

namespace plumb {

/// What is found out of models by trying them.
struct Trials {
  std::function<bool(const Levels&)> sufficient;
  std::function<double(const Levels& a, const Levels& b)> cost_ratio;  // of a to b, about
  std::function<bool(const Levels& a, const Levels& b)> cheaper;       // a than b, beyond chance and worth the while
};

/// The cheapest sufficient model that dropping one feature after another leads to, those first that save the most by
/// themselves; then whatever turns out to save nothing is put back. The full model, where that is not sufficient.
Levels least_model(const std::vector<Drop>&, std::size_t features, const Trials&);

}  // namespace plumb
